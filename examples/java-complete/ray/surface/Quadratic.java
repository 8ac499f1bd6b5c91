package ray.surface;

/** The real roots of a t^2 + 2 b t + c, smaller one first. */
final class Quadratic {

    final boolean hasRoots;
    final double low;
    final double high;

    Quadratic(double a, double b, double c) {
        double discriminant = b * b - a * c;
        hasRoots = discriminant >= 0 && a != 0;
        // -b and the square root are added with the same sign, so that no digits cancel; the product of
        // the roots, c / a, gives the other one.
        double q = b > 0 ? -b - Math.sqrt(discriminant) : -b + Math.sqrt(discriminant);
        double first = q / a;
        double second = q == 0 ? first : c / q;
        low = Math.min(first, second);
        high = Math.max(first, second);
    }
}
