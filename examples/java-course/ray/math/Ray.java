package ray.math;

/** A ray with its range; the direction need not have unit length. */
public class Ray {

    public static final double EPSILON = 1e-6;

    public final Vec origin;
    public final Vec direction;
    public final double tMin;
    public final double tMax;

    public Ray(Vec origin, Vec direction) {
        this(origin, direction, EPSILON, Double.POSITIVE_INFINITY);
    }

    public Ray(Vec origin, Vec direction, double tMin, double tMax) {
        this.origin = origin;
        this.direction = direction;
        this.tMin = tMin;
        this.tMax = tMax;
    }

    public Vec at(double t) {
        return origin.add(direction.scale(t));
    }
}
