package ray.shader;

import ray.Scene;
import ray.math.Color;

/** A thin clear layer over another shader. */
public class Glazed extends Dielectric {

    private Shader substrate;

    public void setSubstrate(Shader substrate) {
        this.substrate = substrate;
    }

    @Override
    public void check() {
        super.check();
        if (substrate == null) {
            throw new IllegalArgumentException("a glaze has no <substrate>");
        }
    }

    @Override
    public Color shade(Scene scene, ShadingPoint at) {
        double cosine = at.normal.dot(at.toViewer);
        if (cosine <= 0) {
            return substrate.shade(scene, at);
        }
        double r = fresnel(cosine, 1 / refractiveIndex());
        Color mirrored = scene.trace(at.reflection(), at.depth + 1, r * at.contribution);
        return substrate.shade(scene, at.weighted(1 - r)).times(1 - r).plus(mirrored.times(r));
    }
}
