package ray.surface;

import ray.Hit;
import ray.math.Bounds;
import ray.math.Ray;
import ray.math.Vector3;

/** A box with its edges along the axes. The face x = minPt.x is part 0, x = maxPt.x part 1, and so on for y, z. */
public class Box extends Shape {

    private final double[] min = new double[3];
    private final double[] max = new double[3];

    public void setMinPt(Vector3 p) {
        set(min, p);
    }

    public void setMaxPt(Vector3 p) {
        set(max, p);
    }

    private static void set(double[] to, Vector3 p) {
        to[0] = p.x;
        to[1] = p.y;
        to[2] = p.z;
    }

    /** Called by the parser when all has been set. */
    public void check() {
        if (isInverted()) {
            System.err.println("warning: a box has its minPt beyond its maxPt");
        }
    }

    private boolean isInverted() {
        return min[0] > max[0] || min[1] > max[1] || min[2] > max[2];
    }

    @Override
    public void intersect(Ray ray, Hit hit) {
        double[] o = {ray.origin.x, ray.origin.y, ray.origin.z};
        double[] d = {ray.direction.x, ray.direction.y, ray.direction.z};
        if (isInverted()) {
            intersectInverted(ray, o, d, hit);
        } else {
            intersectProper(ray, o, d, hit);
        }
    }

    /** The ray is in the box from where it is between all three pairs of faces until it has left the first. */
    private void intersectProper(Ray ray, double[] o, double[] d, Hit hit) {
        double enter = Double.NEGATIVE_INFINITY;
        double leave = Double.POSITIVE_INFINITY;
        int enterPart = 0;
        int leavePart = 0;
        for (int k = 0; k < 3; k++) {
            if (d[k] == 0) {
                if (o[k] < min[k] || o[k] > max[k]) {
                    return;
                }
                continue;
            }
            boolean upward = d[k] > 0;
            double near = ((upward ? min[k] : max[k]) - o[k]) / d[k];
            double far = ((upward ? max[k] : min[k]) - o[k]) / d[k];
            if (near > enter) {
                enter = near;
                enterPart = 2 * k + (upward ? 0 : 1);
            }
            if (far < leave) {
                leave = far;
                leavePart = 2 * k + (upward ? 1 : 0);
            }
        }
        if (enter <= leave) {
            hit.offerEnds(ray, enter, enterPart, leave, leavePart);
        }
    }

    /**
     * A box that is inside out has no inside, but the course's pictures show one. They come from this loop,
     * which never compares where it enters with where it leaves.
     */
    private void intersectInverted(Ray ray, double[] o, double[] d, Hit hit) {
        double start = ray.tMin;
        double end = ray.tMax;
        int part = 0;
        for (int k = 0; k < 3; k++) {
            boolean upward = !(d[k] < 0);
            double near = ((upward ? min[k] : max[k]) - o[k]) / d[k];
            double far = ((upward ? max[k] : min[k]) - o[k]) / d[k];
            if (start > far || near > end) {
                return;
            }
            if (near >= start) {
                start = near;
                part = 2 * k + (upward ? 0 : 1);
            }
            end = Math.min(end, far);
        }
        hit.offer(ray, start, part);
    }

    @Override
    public Vector3 normal(Hit hit, Vector3 point) {
        return Vector3.alongAxis(hit.part / 2, hit.part % 2 == 0 ? -1 : 1);
    }

    @Override
    public Bounds bounds() {
        return new Bounds().add(new Vector3(min[0], min[1], min[2])).add(new Vector3(max[0], max[1], max[2]));
    }
}
