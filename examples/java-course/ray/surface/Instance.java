package ray.surface;

import ray.Hit;
import ray.math.Ray;
import ray.math.Transform;
import ray.math.Vec;
import ray.shader.Shader;

/** A surface at its place in the world. */
public class Instance {

    public final Shader shader;
    private final Surface surface;
    private final Transform toObject;

    Instance(Surface surface, Transform toObject, Shader shader) {
        this.surface = surface;
        this.toObject = toObject;
        this.shader = shader;
    }

    /** Leaves the hit's normal in the surface's coordinates. The t is the same in both. */
    public boolean intersect(Ray ray, Hit hit) {
        return surface.intersect(new Ray(toObject.point(ray.origin), toObject.vector(ray.direction),
                ray.tMin, ray.tMax), hit);
    }

    public Vec normalToWorld(Vec normal) {
        return toObject.transposedVector(normal).unit();
    }
}
