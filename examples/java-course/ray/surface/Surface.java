package ray.surface;

import java.util.List;

import ray.Hit;
import ray.math.Ray;
import ray.math.Transform;
import ray.shader.Shader;

/** A shape in its own coordinates. */
public abstract class Surface {

    protected Shader shader;

    public void setShader(Shader shader) {
        this.shader = shader;
    }

    /** Puts this surface, or what it consists of, into the list. */
    public void place(Transform world, Shader inherited, List<Instance> list) {
        list.add(new Instance(this, world.inverse(), shader != null ? shader : inherited));
    }

    /** Whether the ray meets this surface in its range; then `hit` has the first such point. */
    public abstract boolean intersect(Ray ray, Hit hit);
}
