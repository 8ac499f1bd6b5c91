package ray.shader;

/** What glaze and glass have in common: the laws of Snell and Fresnel. */
abstract class Dielectric implements Shader {

    private double refractiveIndex;

    public void setRefractiveIndex(double index) {
        if (!(index > 0)) {
            throw new IllegalArgumentException("a refractive index must be greater than 0");
        }
        refractiveIndex = index;
    }

    protected double refractiveIndex() {
        return refractiveIndex;
    }

    /** Called by the parser when all has been set. */
    public void check() {
        if (refractiveIndex == 0) {
            throw new IllegalArgumentException("a dielectric has no <refractiveIndex>");
        }
    }

    /**
     * The squared cosine of the refracted ray's angle with the normal; negative for total reflection.
     *
     * @param ratio index on the side of the viewer over that on the other side
     */
    static double squaredCosine(double cosine, double ratio) {
        return 1 - ratio * ratio * (1 - cosine * cosine);
    }

    /** The share of light that is reflected: the mean of the two polarisations. */
    static double fresnel(double cosine, double ratio) {
        double squared = squaredCosine(cosine, ratio);
        if (squared < 0) {
            return 1;
        }
        double refracted = Math.sqrt(squared);
        double parallel = (cosine - ratio * refracted) / (cosine + ratio * refracted);
        double perpendicular = (ratio * cosine - refracted) / (ratio * cosine + refracted);
        return (parallel * parallel + perpendicular * perpendicular) / 2;
    }
}
