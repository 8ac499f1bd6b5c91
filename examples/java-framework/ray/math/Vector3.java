package ray.math;

public class Vector3 extends Tuple3 {

    public Vector3() {
        super(0, 0, 0);
    }

    public Vector3(double x, double y, double z) {
        super(x, y, z);
    }

    /** Sets this to the way from one point to another. */
    public void sub(Tuple3 to, Tuple3 from) {
        set(to.x - from.x, to.y - from.y, to.z - from.z);
    }

    public void cross(Vector3 a, Vector3 b) {
        set(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    }

    public double dot(Vector3 o) {
        return x * o.x + y * o.y + z * o.z;
    }

    public double length() {
        return Math.sqrt(dot(this));
    }

    /** Makes this of unit length; the largest coordinate is divided out first, so that no square overflows. */
    public void normalize() {
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (largest == 0) {
            return;
        }
        set(x / largest, y / largest, z / largest);
        double length = length();
        set(x / length, y / length, z / length);
    }
}
