package ray.math;

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

    /** Used by the parser: "1 2 3". */
    public static Vec parse(String text) {
        String[] words = text.trim().split("\\s+");
        if (words.length != 3) {
            throw new IllegalArgumentException("three numbers expected, not '" + text.trim() + "'");
        }
        return new Vec(Double.parseDouble(words[0]), Double.parseDouble(words[1]),
                Double.parseDouble(words[2]));
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

    public Vec negate() {
        return new Vec(-x, -y, -z);
    }

    public double dot(Vec o) {
        return x * o.x + y * o.y + z * o.z;
    }

    public Vec cross(Vec o) {
        return new Vec(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
    }

    public double length() {
        return Math.sqrt(dot(this));
    }

    public Vec unit() {
        double length = length();
        return new Vec(x / length, y / length, z / length);
    }
}
