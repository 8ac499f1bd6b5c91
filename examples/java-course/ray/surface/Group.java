package ray.surface;

import java.util.ArrayList;
import java.util.List;

import ray.Hit;
import ray.math.Ray;
import ray.math.Transform;
import ray.math.Vec;
import ray.shader.Shader;

/** Surfaces that are transformed together. The transformation first in the file is outermost. */
public class Group extends Surface {

    private final List<Surface> children = new ArrayList<>();
    private Transform transform = Transform.IDENTITY;

    public void addSurface(Surface surface) {
        children.add(surface);
    }

    public void setTranslate(Vec v) {
        transform = transform.times(Transform.translation(v));
    }

    public void setScale(Vec v) {
        transform = transform.times(Transform.scaling(v));
    }

    /** Degrees about the three axes. */
    public void setRotate(Vec v) {
        transform = transform.times(Transform.rotation(0, v.x)).times(Transform.rotation(1, v.y))
                .times(Transform.rotation(2, v.z));
    }

    @Override
    public void place(Transform world, Shader inherited, List<Instance> list) {
        for (Surface child : children) {
            child.place(world.times(transform), shader != null ? shader : inherited, list);
        }
    }

    @Override
    public boolean intersect(Ray ray, Hit hit) {
        throw new IllegalStateException("only a group's children are placed");
    }
}
