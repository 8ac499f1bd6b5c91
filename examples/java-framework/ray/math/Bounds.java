package ray.math;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** The box around what is added to it. Sums are exact, and rounded once, outward, when the corners are asked for. */
public final class Bounds {

    private static final MathContext UP = new MathContext(60, RoundingMode.CEILING);

    private final BigDecimal[] low = new BigDecimal[3];
    private final BigDecimal[] high = new BigDecimal[3];

    /** Adds a point of object space under a transformation. */
    public void add(Matrix4 transformation, double x, double y, double z) {
        for (int i = 0; i < 3; i++) {
            BigDecimal place = place(transformation, i, x, y, z);
            add(i, place, place);
        }
    }

    /** Adds a ball of object space, which becomes an ellipsoid. */
    public void addBall(Matrix4 transformation, Point3 center, double radius) {
        addRound(transformation, center, 0, radius, 3);
    }

    /** Adds a disc across the z axis of object space, at some height over a point. */
    public void addDisc(Matrix4 transformation, Point3 center, double height, double radius) {
        addRound(transformation, center, height, radius, 2);
    }

    /** Along a world axis, a circle or a ball reaches its radius times the length of the row, of its own axes' part. */
    private void addRound(Matrix4 transformation, Point3 center, double height, double radius, int axes) {
        for (int i = 0; i < 3; i++) {
            BigDecimal middle = place(transformation, i, center.x, center.y, center.z)
                    .add(product(transformation.get(i, 2), height));
            BigDecimal square = BigDecimal.ZERO;
            for (int j = 0; j < axes; j++) {
                BigDecimal part = product(transformation.get(i, j), radius);
                square = square.add(part.multiply(part));
            }
            BigDecimal reach = squareRootFromAbove(square);
            add(i, middle.subtract(reach), middle.add(reach));
        }
    }

    private void add(int axis, BigDecimal from, BigDecimal to) {
        low[axis] = low[axis] == null ? from : low[axis].min(from);
        high[axis] = high[axis] == null ? to : high[axis].max(to);
    }

    /** One world coordinate of a point of object space. */
    private static BigDecimal place(Matrix4 transformation, int i, double x, double y, double z) {
        return product(transformation.get(i, 0), x).add(product(transformation.get(i, 1), y))
                .add(product(transformation.get(i, 2), z)).add(new BigDecimal(transformation.get(i, 3)));
    }

    private static BigDecimal product(double a, double b) {
        return new BigDecimal(a).multiply(new BigDecimal(b));
    }

    /** A step of Newton's from any positive number lands above the root, by half the square of the relative error. */
    private static BigDecimal squareRootFromAbove(BigDecimal square) {
        if (square.signum() == 0) {
            return square;
        }
        double root = Math.sqrt(Math.min(square.doubleValue(), Double.MAX_VALUE));
        BigDecimal guess = new BigDecimal(Math.max(root, Double.MIN_NORMAL));
        return guess.add(square.divide(guess, UP)).divide(new BigDecimal(2), UP);
    }

    public Point3 min() {
        return new Point3(down(low[0]), down(low[1]), down(low[2]));
    }

    public Point3 max() {
        return new Point3(-down(high[0].negate()), -down(high[1].negate()), -down(high[2].negate()));
    }

    private static double down(BigDecimal value) {
        double nearest = value.doubleValue();
        return new BigDecimal(nearest).compareTo(value) > 0 ? Math.nextDown(nearest) : nearest;
    }
}
