package ray.shader;

import ray.Light;
import ray.Scene;
import ray.math.Vec;

public class Lambertian extends Shader {

    protected Vec diffuseColor = new Vec(1, 1, 1);

    public void setDiffuseColor(Vec color) {
        diffuseColor = color;
    }

    @Override
    public Vec shade(Scene scene, Vec point, Vec normal, Vec v, int depth, double contribution) {
        Vec color = Vec.ZERO;
        for (Light light : scene.lights) {
            if (scene.sees(point, light)) {
                Vec l = light.position.sub(point).unit();
                color = color.add(light.intensity.times(factor(normal, l, v)));
            }
        }
        return color;
    }

    /** What the surface makes of white light from l. */
    protected Vec factor(Vec n, Vec l, Vec v) {
        return diffuseColor.scale(Math.max(0, n.dot(l)));
    }
}
