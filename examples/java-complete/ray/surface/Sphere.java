package ray.surface;

import ray.Hit;
import ray.math.Bounds;
import ray.math.Ray;
import ray.math.Vector3;

public class Sphere extends Shape {

    private Vector3 center = Vector3.ZERO;
    private double radius = 1;

    public void setCenter(Vector3 center) {
        this.center = center;
    }

    public void setRadius(double radius) {
        this.radius = notNegative(radius);
    }

    @Override
    public void intersect(Ray ray, Hit hit) {
        Vector3 o = ray.origin.minus(center);
        Quadratic inside = new Quadratic(ray.direction.dot(ray.direction), o.dot(ray.direction),
                o.dot(o) - radius * radius);
        if (inside.hasRoots) {
            hit.offerEnds(ray, inside.low, 0, inside.high, 0);
        }
    }

    @Override
    public Vector3 normal(Hit hit, Vector3 point) {
        return point.minus(center);
    }

    @Override
    public Bounds bounds() {
        Vector3 corner = new Vector3(radius, radius, radius);
        return new Bounds().add(center.minus(corner)).add(center.plus(corner));
    }
}
