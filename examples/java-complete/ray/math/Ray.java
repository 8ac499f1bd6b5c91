package ray.math;

/** The points origin + t direction with t in [tMin, tMax]. The direction may have any length. */
public final class Ray {

    /** How far a ray starts off the surface it leaves, so that it does not hit it again there. */
    public static final double EPSILON = 1e-6;

    public final Vector3 origin;
    public final Vector3 direction;
    public final double tMin;
    public final double tMax;

    public Ray(Vector3 origin, Vector3 direction, double tMin, double tMax) {
        this.origin = origin;
        this.direction = direction;
        this.tMin = tMin;
        this.tMax = tMax;
    }

    /** A ray without an end. */
    public Ray(Vector3 origin, Vector3 direction) {
        this(origin, direction, EPSILON, Double.POSITIVE_INFINITY);
    }

    public Vector3 at(double t) {
        return new Vector3(origin.x + t * direction.x, origin.y + t * direction.y, origin.z + t * direction.z);
    }
}
