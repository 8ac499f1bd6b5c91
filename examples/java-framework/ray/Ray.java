package ray;

import ray.math.Point3;
import ray.math.Vector3;

/** A ray with its range [start, end]; t counts in lengths of the direction, which need not be 1. */
public class Ray {

    public static final double EPSILON = 1e-6;

    public final Point3 origin = new Point3();
    public final Vector3 direction = new Vector3();
    public double start;
    public double end;

    public Ray() {
        makeOffsetRay();
    }

    public Ray(Point3 origin, Vector3 direction) {
        this.origin.set(origin);
        this.direction.set(direction);
        makeOffsetRay();
    }

    public void evaluate(Point3 point, double t) {
        point.set(origin);
        point.scaleAdd(t, direction);
    }

    /** Leaves out the surface that the ray starts on. */
    public void makeOffsetRay() {
        start = EPSILON;
        end = Double.POSITIVE_INFINITY;
    }
}
