package ray.shader;

import ray.Scene;
import ray.math.Vec;

/** What a surface looks like. */
public abstract class Shader {

    /** The colour of a point with this normal, seen from the unit direction v. */
    public abstract Vec shade(Scene scene, Vec point, Vec normal, Vec v, int depth, double contribution);

    static Vec reflect(Vec v, Vec n) {
        return n.scale(2 * n.dot(v)).sub(v);
    }

    /** The cosine on the other side by Snell's law, or -1 for total internal reflection. */
    static double refractedCosine(double cosine, double n1, double n2) {
        double squared = 1 - (n1 / n2) * (n1 / n2) * (1 - cosine * cosine);
        return squared < 0 ? -1 : Math.sqrt(squared);
    }

    /** Fresnel's reflection factor for unpolarised light that goes from index n1 to n2. */
    static double fresnel(double cos1, double cos2, double n1, double n2) {
        double rp = (n2 * cos1 - n1 * cos2) / (n2 * cos1 + n1 * cos2);
        double rs = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
        return (rp * rp + rs * rs) / 2;
    }
}
