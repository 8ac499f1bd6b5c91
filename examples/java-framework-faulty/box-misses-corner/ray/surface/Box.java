package ray.surface;

import ray.IntersectionRecord;
import ray.Ray;
import ray.math.Bounds;
import ray.math.Point3;
import ray.math.Vector3;

/** A box along the axes of its own space. */
public class Box extends Surface {

    protected final Point3 minPt = new Point3();
    protected final Point3 maxPt = new Point3();

    public void setMinPt(Point3 minPt) {
        this.minPt.set(minPt);
    }

    public void setMaxPt(Point3 maxPt) {
        this.maxPt.set(maxPt);
    }

    @Override
    public boolean intersect(IntersectionRecord record, Ray ray) {
        Ray object = untransformRay(ray);
        double near = Double.NEGATIVE_INFINITY;
        double far = Double.POSITIVE_INFINITY;
        int nearAxis = 0;
        int farAxis = 0;
        for (int i = 0; i < 3; i++) {
            double o = object.origin.get(i);
            double d = object.direction.get(i);
            if (d == 0) {
                if (o < minPt.get(i) || o > maxPt.get(i)) {
                    return false;
                }
                continue;
            }
            double first = ((d > 0 ? minPt : maxPt).get(i) - o) / d;
            double last = ((d > 0 ? maxPt : minPt).get(i) - o) / d;
            if (first > near) {
                near = first;
                nearAxis = i;
            }
            if (last < far) {
                far = last;
                farAxis = i;
            }
        }
        boolean enters = near >= ray.start;
        double t = enters ? near : far;
        if (near > far || t < ray.start || t > ray.end) {
            return false;
        }
        int axis = enters ? nearAxis : farAxis;
        double side = Math.signum(object.direction.get(axis)) * (enters ? -1 : 1);
        return report(record, ray, t, new Vector3(axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0));
    }

    @Override
    public void computeBoundingBox() {
        Bounds bounds = new Bounds();
        bounds.add(tMat, minPt.x, minPt.y, minPt.z);
        bounds.add(tMat, maxPt.x, minPt.y, minPt.z);
        bounds.add(tMat, minPt.x, maxPt.y, minPt.z);
        bounds.add(tMat, minPt.x, minPt.y, maxPt.z);
        bounds.add(tMat, maxPt.x, maxPt.y, minPt.z);
        bounds.add(tMat, maxPt.x, minPt.y, maxPt.z);
        bounds.add(tMat, maxPt.x, maxPt.y, maxPt.z);
        setBox(bounds.min(), bounds.max());
    }
}
