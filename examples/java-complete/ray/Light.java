package ray;

import ray.math.Color;
import ray.math.Vector3;

/** A light at a point, as strong at any distance. */
public class Light {

    private Vector3 position = Vector3.ZERO;
    private Color intensity = Color.WHITE;

    public void setPosition(Vector3 position) {
        this.position = position;
    }

    public void setIntensity(Color intensity) {
        this.intensity = intensity;
    }

    /** Another name for the intensity. */
    public void setColor(Color color) {
        this.intensity = color;
    }

    public Vector3 position() {
        return position;
    }

    public Color intensity() {
        return intensity;
    }
}
