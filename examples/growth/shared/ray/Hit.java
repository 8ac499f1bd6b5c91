package ray;

/** Where a ray meets something. */
public class Hit {

    /** At first the end of the ray. */
    public double t;
    public Surface surface;
    public Vec normal;

    public Hit(double end) {
        t = end;
    }

    /** Takes a root if it is in range and nearer than the one before. */
    public boolean offer(double root, Surface s, Vec n) {
        if (root >= Ray.EPSILON && root <= t
                && (root < t || surface == null || s.place < surface.place)) {
            t = root;
            surface = s;
            normal = n;
            return true;
        }
        return false;
    }
}
