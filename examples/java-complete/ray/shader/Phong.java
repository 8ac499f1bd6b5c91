package ray.shader;

import ray.math.Color;
import ray.math.Vector3;

/** A matt surface with highlights, by the half vector between light and viewer (Blinn's way). */
public class Phong extends Lambertian {

    private Color specularColor = Color.WHITE;
    private double exponent = 1;

    public void setSpecularColor(Color color) {
        specularColor = color;
    }

    public void setExponent(double exponent) {
        if (exponent < 0) {
            throw new IllegalArgumentException("an exponent is negative");
        }
        this.exponent = exponent;
    }

    @Override
    protected Color reflected(ShadingPoint at, Vector3 toLight) {
        Vector3 half = toLight.plus(at.toViewer).unit();
        double highlight = Math.pow(Math.max(0, at.normal.dot(half)), exponent);
        return super.reflected(at, toLight).plus(specularColor.times(highlight));
    }
}
