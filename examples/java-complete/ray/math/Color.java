package ray.math;

/** An amount of light in linear red, green and blue; like a vector it never changes. */
public final class Color {

    public static final Color BLACK = new Color(0, 0, 0);
    public static final Color WHITE = new Color(1, 1, 1);

    public final double r;
    public final double g;
    public final double b;

    public Color(double r, double g, double b) {
        this.r = r;
        this.g = g;
        this.b = b;
    }

    public Color plus(Color o) {
        return new Color(r + o.r, g + o.g, b + o.b);
    }

    public Color times(double s) {
        return new Color(s * r, s * g, s * b);
    }

    /** Channel by channel: light of one colour on a surface of another. */
    public Color times(Color o) {
        return new Color(r * o.r, g * o.g, b * o.b);
    }
}
