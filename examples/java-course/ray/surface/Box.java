package ray.surface;

import ray.Hit;
import ray.math.Ray;
import ray.math.Vec;

/** A box along the axes. */
public class Box extends Surface {

    private Vec low = Vec.ZERO;
    private Vec high = Vec.ZERO;

    public void setMinPt(Vec p) {
        low = p;
    }

    public void setMaxPt(Vec p) {
        high = p;
    }

    @Override
    public boolean intersect(Ray ray, Hit hit) {
        double start = ray.tMin;
        double end = ray.tMax;
        int startAxis = -1;
        int endAxis = -1;
        for (int i = 0; i < 3; i++) {
            double o = ray.origin.get(i);
            double d = ray.direction.get(i);
            if (d == 0) {
                if (o < low.get(i) || o > high.get(i)) {
                    return false;
                }
                continue;
            }
            double near = ((d > 0 ? low : high).get(i) - o) / d;
            double far = ((d > 0 ? high : low).get(i) - o) / d;
            if (start > far || near > end) {
                return false;
            }
            if (near > start) {
                start = near;
                startAxis = i;
            }
            if (far < end) {
                end = far;
                endAxis = i;
            }
        }
        if (startAxis >= 0) {
            return hit.offer(ray, start, face(startAxis, -ray.direction.get(startAxis)));
        }
        return endAxis >= 0 && hit.offer(ray, end, face(endAxis, ray.direction.get(endAxis)));
    }

    private static Vec face(int axis, double sign) {
        double s = Math.signum(sign);
        return new Vec(axis == 0 ? s : 0, axis == 1 ? s : 0, axis == 2 ? s : 0);
    }
}
