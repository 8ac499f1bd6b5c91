package ray.shader;

import ray.Scene;
import ray.math.Color;
import ray.math.Ray;
import ray.math.Vector3;

/** The surface between air, on the side of the normal, and a clear material. */
public class Glass extends Dielectric {

    @Override
    public Color shade(Scene scene, ShadingPoint at) {
        boolean fromInside = at.normal.dot(at.toViewer) < 0;
        Vector3 normal = fromInside ? at.normal.negated() : at.normal;
        double ratio = fromInside ? refractiveIndex() : 1 / refractiveIndex();
        double cosine = normal.dot(at.toViewer);

        double r = fresnel(cosine, ratio);
        Color mirrored = scene.trace(at.reflection(), at.depth + 1, r * at.contribution).times(r);
        double squared = squaredCosine(cosine, ratio);
        if (squared < 0) {
            return mirrored;
        }
        Vector3 along = normal.times(ratio * cosine - Math.sqrt(squared)).minus(at.toViewer.times(ratio));
        Color refracted = scene.trace(new Ray(at.position, along), at.depth + 1, (1 - r) * at.contribution);
        return mirrored.plus(refracted.times(1 - r));
    }
}
