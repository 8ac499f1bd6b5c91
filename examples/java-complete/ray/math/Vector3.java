package ray.math;

/** A point or a vector in space. It never changes: each operation makes a new one. */
public final class Vector3 {

    public static final Vector3 ZERO = new Vector3(0, 0, 0);

    public final double x;
    public final double y;
    public final double z;

    public Vector3(double x, double y, double z) {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    public Vector3 plus(Vector3 o) {
        return new Vector3(x + o.x, y + o.y, z + o.z);
    }

    public Vector3 minus(Vector3 o) {
        return new Vector3(x - o.x, y - o.y, z - o.z);
    }

    public Vector3 times(double s) {
        return new Vector3(s * x, s * y, s * z);
    }

    public Vector3 negated() {
        return new Vector3(-x, -y, -z);
    }

    public double dot(Vector3 o) {
        return x * o.x + y * o.y + z * o.z;
    }

    public Vector3 cross(Vector3 o) {
        return new Vector3(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
    }

    public double length() {
        return Math.sqrt(dot(this));
    }

    /** The vector of length 1 in the same direction; the zero vector stays what it is. */
    public Vector3 unit() {
        double length = length();
        return length > 0 ? new Vector3(x / length, y / length, z / length) : this;
    }

    /** The vector along an axis: 0, 1, 2 for x, y, z. */
    public static Vector3 alongAxis(int axis, double length) {
        return new Vector3(axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0);
    }
}
