package ray.surface;

import java.util.List;

import ray.Hit;
import ray.math.Bounds;
import ray.math.Matrix4;
import ray.math.Ray;
import ray.math.Vector3;
import ray.shader.Shader;

/** Something that a ray can hit, in coordinates of its own. */
public abstract class Shape extends Surface {

    /** Offers the hit the points in which the ray meets the shape: all of them, or at least the nearest. */
    public abstract void intersect(Ray ray, Hit hit);

    /** The outward normal, of any length, at a point that was hit. */
    public abstract Vector3 normal(Hit hit, Vector3 point);

    public abstract Bounds bounds();

    @Override
    public void place(Matrix4 toWorld, Shader inherited, List<Instance> instances) {
        instances.add(new Instance(instances.size(), this, toWorld, shader != null ? shader : inherited));
    }

    /** For setters of what cannot be negative. */
    static double notNegative(double value) {
        if (value < 0) {
            throw new IllegalArgumentException(value + " is negative");
        }
        return value;
    }
}
