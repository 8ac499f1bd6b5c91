package ray;

/** A ray; its direction need not have unit length. */
public class Ray {

    public static final double EPSILON = 1e-6;

    public final Vec origin;
    public final Vec direction;

    public Ray(Vec origin, Vec direction) {
        this.origin = origin;
        this.direction = direction;
    }

    public Vec at(double t) {
        return origin.add(direction.scale(t));
    }
}
