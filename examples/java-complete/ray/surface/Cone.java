package ray.surface;

/**
 * A cone, cut off at both ends; the radius is that at the centre. With its tip between the ends, it is a double cone.
 */
public class Cone extends RoundSolid {

    private double tipZ;

    public void setTipZ(double tipZ) {
        this.tipZ = tipZ;
    }

    /** Called by the parser when all has been set. */
    public void check() {
        if (tipZ == center.z) {
            throw new IllegalArgumentException("the tip of a cone is at its centre");
        }
    }

    // The radius is k (z - tip), with z and the tip counted from the centre.

    private double tip() {
        return tipZ - center.z;
    }

    @Override
    protected double squaredRadius(double z) {
        return curvature() * (z - tip()) * (z - tip());
    }

    @Override
    protected double halfSlope(double z) {
        return curvature() * (z - tip());
    }

    @Override
    protected double curvature() {
        return radius * radius / (tip() * tip());
    }
}
