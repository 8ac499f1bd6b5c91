package ray;

import ray.math.Vec;

/** A point light that does not get weaker with the distance. */
public class Light {

    public Vec position = Vec.ZERO;
    public Vec intensity = new Vec(1, 1, 1);

    public void setPosition(Vec position) {
        this.position = position;
    }

    public void setIntensity(Vec intensity) {
        this.intensity = intensity;
    }

    public void setColor(Vec color) {
        this.intensity = color;
    }
}
