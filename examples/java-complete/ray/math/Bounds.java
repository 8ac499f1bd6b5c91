package ray.math;

/** A box along the axes that grows around what is put into it; empty at first. */
public final class Bounds {

    /** More than rounding can move a hit, less than would be seen in the time of a search. */
    private static final double MARGIN = 1e-9;

    /** Smallest x, y, z, then largest x, y, z. */
    public final double[] side = {
        Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY
    };

    public Bounds add(Vector3 p) {
        side[0] = Math.min(side[0], p.x);
        side[1] = Math.min(side[1], p.y);
        side[2] = Math.min(side[2], p.z);
        side[3] = Math.max(side[3], p.x);
        side[4] = Math.max(side[4], p.y);
        side[5] = Math.max(side[5], p.z);
        return this;
    }

    /** The box around all eight corners of this one after a transformation. */
    public Bounds transformed(Matrix4 matrix) {
        Bounds result = new Bounds();
        for (int corner = 0; corner < 8; corner++) {
            double x = side[(corner & 1) == 0 ? 0 : 3];
            double y = side[(corner & 2) == 0 ? 1 : 4];
            double z = side[(corner & 4) == 0 ? 2 : 5];
            result.add(matrix.point(new Vector3(x, y, z)));
        }
        return result;
    }

    /** Writes the box, a little widened against rounding, as six numbers into a list of such boxes. */
    public void store(double[] boxes, int index) {
        double size = 0;
        for (double s : side) {
            size = Math.max(size, Math.abs(s));
        }
        for (int k = 0; k < 3; k++) {
            boxes[6 * index + k] = side[k] - MARGIN * size;
            boxes[6 * index + 3 + k] = side[3 + k] + MARGIN * size;
        }
    }
}
