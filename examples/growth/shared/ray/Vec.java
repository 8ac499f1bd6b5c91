package ray;

/** A point, a direction or a colour. */
public final class Vec {

    public static final Vec ZERO = new Vec(0, 0, 0);

    public final double x;
    public final double y;
    public final double z;

    public Vec(double x, double y, double z) {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    public double get(int i) {
        return i == 0 ? x : i == 1 ? y : z;
    }

    public Vec add(Vec o) {
        return new Vec(x + o.x, y + o.y, z + o.z);
    }

    public Vec sub(Vec o) {
        return new Vec(x - o.x, y - o.y, z - o.z);
    }

    public Vec scale(double s) {
        return new Vec(x * s, y * s, z * s);
    }

    /** Component by component, as for colours. */
    public Vec times(Vec o) {
        return new Vec(x * o.x, y * o.y, z * o.z);
    }

    public double dot(Vec o) {
        return x * o.x + y * o.y + z * o.z;
    }

    public Vec cross(Vec o) {
        return new Vec(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
    }

    public Vec unit() {
        return scale(1 / Math.sqrt(dot(this)));
    }

    public Vec min(Vec o) {
        return new Vec(Math.min(x, o.x), Math.min(y, o.y), Math.min(z, o.z));
    }

    public Vec max(Vec o) {
        return new Vec(Math.max(x, o.x), Math.max(y, o.y), Math.max(z, o.z));
    }
}
