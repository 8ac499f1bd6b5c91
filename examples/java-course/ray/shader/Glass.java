package ray.shader;

import ray.RayTracer;
import ray.Scene;
import ray.math.Ray;
import ray.math.Vec;

/** The boundary between air, on the side of the normal, and glass. */
public class Glass extends Shader {

    private double refractiveIndex;

    public void setRefractiveIndex(double index) {
        refractiveIndex = index;
    }

    /** Called by the parser when all has been read. */
    public void finish() {
        if (!(refractiveIndex > 0)) {
            throw new IllegalArgumentException("Glass needs a refractiveIndex above 0");
        }
    }

    @Override
    public Vec shade(Scene scene, Vec point, Vec normal, Vec v, int depth, double contribution) {
        boolean inside = normal.dot(v) < 0;
        Vec n = inside ? normal.negate() : normal;
        double n1 = inside ? refractiveIndex : 1;
        double n2 = inside ? 1 : refractiveIndex;
        double cosine = n.dot(v);
        double other = refractedCosine(cosine, n1, n2);
        double r = other < 0 ? 1 : fresnel(cosine, other, n1, n2);
        Ray reflected = new Ray(point, reflect(v, n));
        Vec color = RayTracer.shadeRay(scene, reflected, depth + 1, contribution * r).scale(r);
        if (other < 0) {
            return color;
        }
        Vec direction = n.scale(n1 / n2 * cosine - other).sub(v.scale(n1 / n2));
        Ray refracted = new Ray(point, direction);
        return color.add(RayTracer.shadeRay(scene, refracted, depth + 1, contribution * (1 - r))
                .scale(1 - r));
    }
}
