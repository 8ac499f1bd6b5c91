package ray.shader;

import ray.math.Ray;
import ray.math.Vector3;

/** A point that is looked at, in the world, and how the look got there. */
public final class ShadingPoint {

    public final Vector3 position;

    /** Unit vectors: the outward normal of the surface, and the way back to where the ray came from. */
    public final Vector3 normal;
    public final Vector3 toViewer;

    /** The number of rays from the camera to here. */
    public final int depth;

    /** How much of the colour of this point counts for its pixel. */
    public final double contribution;

    public ShadingPoint(Vector3 position, Vector3 normal, Vector3 toViewer, int depth, double contribution) {
        this.position = position;
        this.normal = normal;
        this.toViewer = toViewer;
        this.depth = depth;
        this.contribution = contribution;
    }

    /** The same point where it counts for less. */
    ShadingPoint weighted(double weight) {
        return new ShadingPoint(position, normal, toViewer, depth, weight * contribution);
    }

    /** The ray that a mirror here would send on; a mirror looks the same from both sides. */
    Ray reflection() {
        return new Ray(position, normal.times(2 * normal.dot(toViewer)).minus(toViewer));
    }
}
