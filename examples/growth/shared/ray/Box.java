package ray;

/** A box with its sides along the axes. */
public class Box {

    public Vec low;
    public Vec high;

    public Box(Vec low, Vec high) {
        this.low = low;
        this.high = high;
    }

    public Box union(Box o) {
        return new Box(low.min(o.low), high.max(o.high));
    }

    /** Whether the ray enters before t = end. */
    public boolean hit(Ray ray, double end) {
        double start = Ray.EPSILON;
        for (int k = 0; k < 3; k++) {
            double o = ray.origin.get(k);
            double d = ray.direction.get(k);
            if (d == 0) {
                if (o < low.get(k) || o > high.get(k)) {
                    return false;
                }
                continue;
            }
            double t0 = (low.get(k) - o) / d;
            double t1 = (high.get(k) - o) / d;
            start = Math.max(start, Math.min(t0, t1));
            end = Math.min(end, Math.max(t0, t1));
        }
        return start <= end;
    }
}
