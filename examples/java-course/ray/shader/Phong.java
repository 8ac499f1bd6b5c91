package ray.shader;

import ray.math.Vec;

/** A Lambertian surface with a highlight. */
public class Phong extends Lambertian {

    private Vec specularColor = new Vec(1, 1, 1);
    private double exponent = 1;

    public void setSpecularColor(Vec color) {
        specularColor = color;
    }

    public void setExponent(double exponent) {
        this.exponent = exponent;
    }

    @Override
    protected Vec factor(Vec n, Vec l, Vec v) {
        Vec h = l.add(v).unit();
        return super.factor(n, l, v)
                .add(specularColor.scale(Math.pow(Math.max(0, n.dot(h)), exponent)));
    }
}
