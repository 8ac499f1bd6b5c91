package ray.surface;

import ray.Hit;
import ray.math.Ray;
import ray.math.Vec;

public class Sphere extends Surface {

    private Vec center = Vec.ZERO;
    private double radius = 1;

    public void setCenter(Vec center) {
        this.center = center;
    }

    public void setRadius(double radius) {
        if (radius < 0) {
            throw new IllegalArgumentException("a radius is negative");
        }
        this.radius = radius;
    }

    @Override
    public boolean intersect(Ray ray, Hit hit) {
        Vec o = ray.origin.sub(center);
        Vec d = ray.direction;
        double a = d.dot(d);
        double b = o.dot(d);
        double discriminant = b * b - a * (o.dot(o) - radius * radius);
        if (discriminant < 0) {
            return false;
        }
        double root = Math.sqrt(discriminant);
        double t0 = (-b - root) / a;
        double t1 = (-b + root) / a;
        return hit.offer(ray, t0, o.add(d.scale(t0))) || hit.offer(ray, t1, o.add(d.scale(t1)));
    }
}
