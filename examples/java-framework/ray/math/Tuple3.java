package ray.math;

/** Three coordinates. */
public class Tuple3 {

    public double x;
    public double y;
    public double z;

    public Tuple3(double x, double y, double z) {
        set(x, y, z);
    }

    public void set(double x, double y, double z) {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    public void set(Tuple3 o) {
        set(o.x, o.y, o.z);
    }

    /** Coordinate 0, 1 or 2. */
    public double get(int axis) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    /** Sets this to itself plus a multiple of another. */
    public void scaleAdd(double factor, Tuple3 o) {
        set(x + factor * o.x, y + factor * o.y, z + factor * o.z);
    }

    @Override
    public String toString() {
        return "(" + x + ", " + y + ", " + z + ")";
    }
}
