package ray.surface;

import ray.Hit;
import ray.math.Ray;
import ray.math.Vec;

/** A closed cylinder around the z axis; its centre is at half its height. */
public class Cylinder extends Surface {

    private Vec center = Vec.ZERO;
    private double radius = 1;
    private double height = 1;

    public void setCenter(Vec center) {
        this.center = center;
    }

    public void setRadius(double radius) {
        this.radius = radius;
        check();
    }

    public void setHeight(double height) {
        this.height = height;
        check();
    }

    private void check() {
        if (radius < 0 || height < 0) {
            throw new IllegalArgumentException("a radius or a height is negative");
        }
    }

    @Override
    public boolean intersect(Ray ray, Hit hit) {
        Vec o = ray.origin.sub(center);
        Vec d = ray.direction;
        boolean found = false;
        double a = d.x * d.x + d.y * d.y;
        double b = o.x * d.x + o.y * d.y;
        double discriminant = b * b - a * (o.x * o.x + o.y * o.y - radius * radius);
        if (a > 0 && discriminant >= 0) {
            for (int sign = -1; sign <= 1; sign += 2) {
                double t = (-b + sign * Math.sqrt(discriminant)) / a;
                Vec p = o.add(d.scale(t));
                if (Math.abs(p.z) <= height / 2) {
                    found |= hit.offer(ray, t, new Vec(p.x, p.y, 0));
                }
            }
        }
        for (int sign = -1; sign <= 1 && d.z != 0; sign += 2) {
            double t = (sign * height / 2 - o.z) / d.z;
            Vec p = o.add(d.scale(t));
            if (p.x * p.x + p.y * p.y <= radius * radius) {
                found |= hit.offer(ray, t, new Vec(0, 0, sign));
            }
        }
        return found;
    }
}
