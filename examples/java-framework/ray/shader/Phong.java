package ray.shader;

import ray.math.Color;

public class Phong extends Lambertian {

    protected Color specularColor = new Color(1, 1, 1);
    protected double exponent = 1;

    public void setSpecularColor(Color specularColor) {
        this.specularColor = specularColor;
    }

    public void setExponent(double exponent) {
        this.exponent = exponent;
    }
}
