package ray.surface;

import ray.IntersectionRecord;
import ray.Ray;
import ray.math.Point3;
import ray.math.Vector3;

public class Sphere extends Surface {

    protected final Point3 center = new Point3();
    protected double radius = 1;

    public void setCenter(Point3 center) {
        this.center.set(center);
    }

    public void setRadius(double radius) {
        if (radius < 0) {
            throw new IllegalArgumentException("a radius is negative");
        }
        this.radius = radius;
    }

    @Override
    public boolean intersect(IntersectionRecord record, Ray ray) {
        Ray object = untransformRay(ray);
        Vector3 d = object.direction;
        Vector3 f = new Vector3();
        f.sub(object.origin, center);
        double a = d.dot(d);
        double b = f.dot(d);
        // The distance of the line from the centre is taken at its nearest point: from the origin's own distance it
        // would be the small difference of two large numbers.
        Vector3 nearest = new Vector3(f.x, f.y, f.z);
        nearest.scaleAdd(-b / a, d);
        double distance = nearest.length();
        double discriminant = (radius - distance) * (radius + distance);
        if (!(a > 0) || discriminant < 0) {
            return false;
        }
        double q = -(b + Math.copySign(Math.sqrt(a * discriminant), b));
        double length = f.length();
        double one = q / a;
        double other = q == 0 ? 0 : (length - radius) * (length + radius) / q;
        double t = Math.min(one, other);
        if (t < ray.start) {
            t = Math.max(one, other);
        }
        if (t < ray.start || t > ray.end) {
            return false;
        }
        Vector3 normal = new Vector3(f.x, f.y, f.z);
        normal.scaleAdd(t, d);
        return report(record, ray, t, normal);
    }

    @Override
    public void computeBoundingBox() {
        setBox(new Point3(center.x - radius, center.y - radius, center.z - radius),
                new Point3(center.x + radius, center.y + radius, center.z + radius));
    }
}
