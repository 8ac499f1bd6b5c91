package ray.surface;

import ray.Hit;
import ray.math.Bounds;
import ray.math.Matrix4;
import ray.math.Ray;
import ray.math.Vector3;
import ray.shader.Shader;

/** A shape at its place in the world. One shape may have several, if groups share it. */
public final class Instance {

    /** Its number in file order. */
    public final int index;
    public final Shader shader;

    private final Shape shape;
    private final Matrix4 toWorld;
    private final Matrix4 toObject;

    Instance(int index, Shape shape, Matrix4 toWorld, Shader shader) {
        this.index = index;
        this.shape = shape;
        this.toWorld = toWorld;
        this.toObject = toWorld.inverse();
        this.shader = shader;
    }

    public void intersect(Ray ray, Hit hit) {
        hit.begin(this);
        shape.intersect(toObject(ray), hit);
    }

    /** The unit normal, in the world, of a hit on this shape. */
    public Vector3 normal(Ray ray, Hit hit) {
        Vector3 normal = shape.normal(hit, toObject(ray).at(hit.t));
        return toObject.transposedVector(normal).unit();
    }

    public Bounds bounds() {
        return shape.bounds().transformed(toWorld);
    }

    /** The direction keeps its new length, so t means the same point in both spaces. */
    private Ray toObject(Ray ray) {
        if (toWorld == Matrix4.IDENTITY) {
            return ray;
        }
        return new Ray(toObject.point(ray.origin), toObject.vector(ray.direction), ray.tMin, ray.tMax);
    }
}
