package ray.shader;

import ray.RayTracer;
import ray.Scene;
import ray.math.Ray;
import ray.math.Vec;

/** A thin layer of glass over another material. */
public class Glazed extends Shader {

    private double refractiveIndex;
    private Shader substrate;

    public void setRefractiveIndex(double index) {
        refractiveIndex = index;
    }

    public void setSubstrate(Shader shader) {
        substrate = shader;
    }

    /** Called by the parser when all has been read. */
    public void finish() {
        if (substrate == null || !(refractiveIndex > 0)) {
            throw new IllegalArgumentException("Glazed needs a substrate and a refractiveIndex above 0");
        }
    }

    @Override
    public Vec shade(Scene scene, Vec point, Vec normal, Vec v, int depth, double contribution) {
        double cosine = normal.dot(v);
        if (cosine <= 0) {
            return substrate.shade(scene, point, normal, v, depth, contribution);
        }
        double other = refractedCosine(cosine, 1, refractiveIndex);
        double r = other < 0 ? 1 : fresnel(cosine, other, 1, refractiveIndex);
        Vec below = substrate.shade(scene, point, normal, v, depth, contribution * (1 - r));
        Ray ray = new Ray(point, reflect(v, normal));
        Vec reflected = RayTracer.shadeRay(scene, ray, depth + 1, contribution * r);
        return below.scale(1 - r).add(reflected.scale(r));
    }
}
