package ray.surface;

import ray.IntersectionRecord;
import ray.Ray;
import ray.math.Bounds;
import ray.math.Point3;
import ray.math.Vector3;

/** A closed cylinder around an axis along z; its centre is at half its height. */
public class Cylinder extends Surface {

    protected final Point3 center = new Point3();
    protected double radius = 1;
    protected double height = 1;

    public void setCenter(Point3 center) {
        this.center.set(center);
    }

    public void setRadius(double radius) {
        if (radius < 0) {
            throw new IllegalArgumentException("a radius is negative");
        }
        this.radius = radius;
    }

    public void setHeight(double height) {
        if (height < 0) {
            throw new IllegalArgumentException("a height is negative");
        }
        this.height = height;
    }

    /** What is inside is where the part of the line within the side and that between the caps overlap: no rim leaks. */
    @Override
    public boolean intersect(IntersectionRecord record, Ray ray) {
        Ray object = untransformRay(ray);
        Vector3 d = object.direction;
        Vector3 f = new Vector3();
        f.sub(object.origin, center);

        double near = Double.NEGATIVE_INFINITY;
        double far = Double.POSITIVE_INFINITY;
        double a = d.x * d.x + d.y * d.y;
        double out = (Math.hypot(f.x, f.y) - radius) * (Math.hypot(f.x, f.y) + radius);
        if (a > 0) {
            double b = f.x * d.x + f.y * d.y;
            double distance = (f.x * d.y - f.y * d.x) / Math.sqrt(a);
            double discriminant = (radius - distance) * (radius + distance);
            if (discriminant < 0) {
                return false;
            }
            double q = -(b + Math.copySign(Math.sqrt(a * discriminant), b));
            double other = q == 0 ? 0 : out / q;
            near = Math.min(q / a, other);
            far = Math.max(q / a, other);
        } else if (out > 0) {
            return false;
        }

        boolean entersByCap = false;
        boolean leavesByCap = false;
        if (d.z != 0) {
            double one = (-height / 2 - f.z) / d.z;
            double other = (height / 2 - f.z) / d.z;
            entersByCap = Math.min(one, other) > near;
            leavesByCap = Math.max(one, other) < far;
            near = Math.max(near, Math.min(one, other));
            far = Math.min(far, Math.max(one, other));
        } else if (Math.abs(f.z) > height / 2) {
            return false;
        }

        boolean enters = near >= ray.start;
        double t = enters ? near : far;
        if (near > far || t < ray.start || t > ray.end) {
            return false;
        }
        Vector3 normal = new Vector3(f.x + t * d.x, f.y + t * d.y, 0);
        if (enters ? entersByCap : leavesByCap) {
            normal.set(0, 0, enters ? -d.z : d.z);
        }
        return report(record, ray, t, normal);
    }

    @Override
    public void computeBoundingBox() {
        Bounds bounds = new Bounds();
        bounds.addDisc(tMat, center, -height / 2, radius);
        bounds.addDisc(tMat, center, height / 2, radius);
        setBox(bounds.min(), bounds.max());
    }
}
