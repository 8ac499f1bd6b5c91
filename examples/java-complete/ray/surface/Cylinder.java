package ray.surface;

public class Cylinder extends RoundSolid {

    @Override
    protected double squaredRadius(double z) {
        return radius * radius;
    }

    @Override
    protected double halfSlope(double z) {
        return 0;
    }

    @Override
    protected double curvature() {
        return 0;
    }
}
