package ray.surface;

import ray.Hit;
import ray.math.Bounds;
import ray.math.Ray;
import ray.math.Vector3;

/**
 * What cylinder and cone have in common: a round side about an axis along z, cut off at half the height
 * above and below the centre and closed there.
 */
abstract class RoundSolid extends Shape {

    private static final int BOTTOM = 0;
    private static final int TOP = 1;
    private static final int SIDE = 2;

    private static final Interval WHOLE_LINE =
            new Interval(Double.NEGATIVE_INFINITY, SIDE, Double.POSITIVE_INFINITY, SIDE);

    protected Vector3 center = Vector3.ZERO;
    protected double radius = 1;
    protected double height = 1;

    public void setCenter(Vector3 center) {
        this.center = center;
    }

    public void setRadius(double radius) {
        this.radius = notNegative(radius);
    }

    public void setHeight(double height) {
        this.height = notNegative(height);
    }

    /** The change of the squared radius, at a height above the centre, is twice this for each unit of height. */
    protected abstract double halfSlope(double z);

    /** The squared radius at a height above the centre. */
    protected abstract double squaredRadius(double z);

    /** How the squared radius is curved: the factor of z^2 in it. */
    protected abstract double curvature();

    @Override
    public void intersect(Ray ray, Hit hit) {
        Vector3 o = ray.origin.minus(center);
        Vector3 d = ray.direction;
        if (d.z == 0) {
            if (Math.abs(o.z) <= height / 2) {
                intersectSide(ray, o, WHOLE_LINE, hit);
            }
            return;
        }
        double atBottom = (-height / 2 - o.z) / d.z;
        double atTop = (height / 2 - o.z) / d.z;
        intersectSide(ray, o, d.z > 0 ? new Interval(atBottom, BOTTOM, atTop, TOP)
                : new Interval(atTop, TOP, atBottom, BOTTOM), hit);
    }

    /** x^2 + y^2 - (squared radius at z) <= 0 is a quadratic inequality in t; the slab is what it is met with. */
    private void intersectSide(Ray ray, Vector3 o, Interval slab, Hit hit) {
        Vector3 d = ray.direction;
        double a = d.x * d.x + d.y * d.y - curvature() * d.z * d.z;
        double b = o.x * d.x + o.y * d.y - halfSlope(o.z) * d.z;
        double c = o.x * o.x + o.y * o.y - squaredRadius(o.z);
        Quadratic roots = new Quadratic(a, b, c);
        if (a > 0) {
            if (roots.hasRoots) {
                slab.meet(roots.low, roots.high).offer(ray, hit);
            }
        } else if (a < 0 && roots.hasRoots) {
            slab.meet(Double.NEGATIVE_INFINITY, roots.low).offer(ray, hit);
            slab.meet(roots.high, Double.POSITIVE_INFINITY).offer(ray, hit);
        } else if (a == 0 && b != 0) {
            double root = -c / (2 * b);
            slab.meet(b < 0 ? root : Double.NEGATIVE_INFINITY, b < 0 ? Double.POSITIVE_INFINITY : root)
                    .offer(ray, hit);
        } else if (c <= 0) {
            slab.offer(ray, hit);
        }
    }

    @Override
    public Vector3 normal(Hit hit, Vector3 point) {
        if (hit.part == SIDE) {
            Vector3 p = point.minus(center);
            return new Vector3(p.x, p.y, -halfSlope(p.z));
        }
        return new Vector3(0, 0, hit.part == TOP ? 1 : -1);
    }

    @Override
    public Bounds bounds() {
        double r = Math.sqrt(Math.max(squaredRadius(-height / 2), squaredRadius(height / 2)));
        Vector3 corner = new Vector3(r, r, height / 2);
        return new Bounds().add(center.minus(corner)).add(center.plus(corner));
    }

    /** A stretch of a ray, with the parts of the surface at its ends. */
    private static final class Interval {

        private final double enter;
        private final int enterPart;
        private final double leave;
        private final int leavePart;

        Interval(double enter, int enterPart, double leave, int leavePart) {
            this.enter = enter;
            this.enterPart = enterPart;
            this.leave = leave;
            this.leavePart = leavePart;
        }

        /** What is left of it between two points of the side. */
        Interval meet(double from, double to) {
            return new Interval(Math.max(enter, from), from > enter ? SIDE : enterPart,
                    Math.min(leave, to), to < leave ? SIDE : leavePart);
        }

        void offer(Ray ray, Hit hit) {
            if (enter <= leave) {
                hit.offerEnds(ray, enter, enterPart, leave, leavePart);
            }
        }
    }
}
