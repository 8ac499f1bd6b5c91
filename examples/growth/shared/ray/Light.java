package ray;

/** A point light that does not get weaker with the distance. */
public class Light {

    public final Vec position;
    public final Vec intensity;

    public Light(Vec position, Vec intensity) {
        this.position = position;
        this.intensity = intensity;
    }
}
