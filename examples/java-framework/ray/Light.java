package ray;

import ray.math.Color;
import ray.math.Point3;

/** A light at a point. */
public class Light {

    protected final Point3 position = new Point3();
    protected Color intensity = new Color(1, 1, 1);

    public void setPosition(Point3 position) {
        this.position.set(position);
    }

    public void setIntensity(Color intensity) {
        this.intensity = intensity;
    }

    public void setColor(Color color) {
        intensity = color;
    }
}
