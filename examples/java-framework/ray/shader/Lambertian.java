package ray.shader;

import ray.math.Color;

public class Lambertian extends Shader {

    protected Color diffuseColor = new Color(1, 1, 1);

    public void setDiffuseColor(Color diffuseColor) {
        this.diffuseColor = diffuseColor;
    }
}
