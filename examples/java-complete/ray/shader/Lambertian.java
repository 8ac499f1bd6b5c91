package ray.shader;

import ray.Light;
import ray.Scene;
import ray.math.Color;
import ray.math.Vector3;

/** A matt surface, which looks the same from everywhere. */
public class Lambertian implements Shader {

    private Color diffuseColor = Color.WHITE;

    public void setDiffuseColor(Color color) {
        diffuseColor = color;
    }

    @Override
    public Color shade(Scene scene, ShadingPoint at) {
        Color sum = Color.BLACK;
        for (Light light : scene.lights()) {
            if (!scene.isInShadow(at.position, light)) {
                Vector3 toLight = light.position().minus(at.position).unit();
                sum = sum.plus(light.intensity().times(reflected(at, toLight)));
            }
        }
        return sum;
    }

    /** The part of the light from a direction that goes to the viewer. */
    protected Color reflected(ShadingPoint at, Vector3 toLight) {
        return diffuseColor.times(Math.max(0, at.normal.dot(toLight)));
    }
}
