package ray;

/** A triangle or a sphere. */
public abstract class Surface {

    /** Among all surfaces of the scene, by which a tie is decided. */
    public int place;
    public Shader shader;

    public abstract void intersect(Ray ray, Hit hit);

    public abstract Box box();

    public abstract Vec centre();
}
