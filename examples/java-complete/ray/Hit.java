package ray;

import ray.math.Ray;
import ray.surface.Instance;

/** The nearest of the points where a ray meets surfaces, as far as they have been tried. */
public final class Hit {

    public double t = Double.POSITIVE_INFINITY;

    /** The surface that is hit; null as long as there is none. */
    public Instance instance;

    /** Which face of a solid, or which triangle of a mesh. */
    public int part;

    /** In a triangle: the weights of its second and third corner. */
    public double beta;
    public double gamma;

    private final boolean anyWillDo;
    private Instance tried;

    /** @param anyWillDo whether it only matters that something is hit, as for a shadow */
    public Hit(boolean anyWillDo) {
        this.anyWillDo = anyWillDo;
    }

    /** Says to whom the next offers belong. */
    public void begin(Instance instance) {
        tried = instance;
    }

    /**
     * Takes a point, if it lies in the ray's range and nearer than the one before. At the same t the surface
     * that comes first in the file counts, and in a mesh the triangle that comes first.
     */
    public boolean offer(Ray ray, double newT, int newPart) {
        if (!(newT >= ray.tMin && newT <= ray.tMax && newT <= t) || newT == t && !isBefore(newPart)) {
            return false;
        }
        t = newT;
        instance = tried;
        part = newPart;
        return true;
    }

    /** Takes where the ray enters a solid or, if it begins inside, where it leaves it. */
    public void offerEnds(Ray ray, double enter, int enterPart, double leave, int leavePart) {
        if (!offer(ray, enter, enterPart)) {
            offer(ray, leave, leavePart);
        }
    }

    private boolean isBefore(int newPart) {
        return instance == null || tried.index < instance.index || tried == instance && newPart < part;
    }

    /** Whether there is no need to search on. */
    public boolean isEnough() {
        return anyWillDo && instance != null;
    }
}
