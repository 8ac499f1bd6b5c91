package ray.surface;

import java.util.List;

import ray.math.Matrix4;
import ray.shader.Shader;

/** What a surface element of a scene file can be: a shape, or a group of surfaces. */
public abstract class Surface {

    protected Shader shader;

    public void setShader(Shader shader) {
        this.shader = shader;
    }

    /**
     * Appends this surface, or the shapes it consists of, to those of the scene.
     *
     * @param inherited the shader of the group around it, for what has none of its own
     */
    public abstract void place(Matrix4 toWorld, Shader inherited, List<Instance> instances);
}
