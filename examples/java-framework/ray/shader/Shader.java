package ray.shader;

/** How a surface looks. Nothing is drawn here: shaders keep what the file says. */
public abstract class Shader {

    public static final Shader DEFAULT = new Lambertian();
}
