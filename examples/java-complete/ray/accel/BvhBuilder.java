package ray.accel;

/** Builds the tree of a Bvh from the top down by the surface area heuristic, with bins. */
final class BvhBuilder {

    private static final int BINS = 16;
    private static final int MOST_IN_A_LEAF = 4;

    /** From this depth on a node is halved whatever it costs, so that no tree gets too deep. */
    private static final int GREATEST_SAH_DEPTH = 48;

    /** Six numbers for each node. */
    final double[] boxes;

    /** Of a leaf, its first place in the order; of another node, the first of its two children, which are adjacent. */
    final int[] first;

    /** How many items a leaf has; 0 for a node that is none. */
    final int[] count;

    /** Of a node that is no leaf, along which axis the first of its children is below the other. */
    final byte[] axis;

    /** The items, leaf by leaf. */
    final int[] order;

    private final double[] itemBoxes;
    private int nodes;

    BvhBuilder(double[] itemBoxes) {
        this.itemBoxes = itemBoxes;
        int items = itemBoxes.length / 6;
        order = new int[items];
        for (int i = 0; i < items; i++) {
            order[i] = i;
        }
        int most = Math.max(1, 2 * items - 1);
        boxes = new double[6 * most];
        first = new int[most];
        count = new int[most];
        axis = new byte[most];
        if (items > 0) {
            nodes = 1;
            build(0, 0, items, 0);
        }
    }

    boolean isEmpty() {
        return nodes == 0;
    }

    boolean isLeaf(int node) {
        return count[node] > 0;
    }

    private void build(int node, int from, int to, int depth) {
        double[] centres = emptyBox();
        double[] box = emptyBox();
        for (int i = from; i < to; i++) {
            grow(box, itemBoxes, 6 * order[i]);
            for (int axis = 0; axis < 3; axis++) {
                double centre = centre(order[i], axis);
                centres[axis] = Math.min(centres[axis], centre);
                centres[3 + axis] = Math.max(centres[3 + axis], centre);
            }
        }
        System.arraycopy(box, 0, boxes, 6 * node, 6);
        if (to - from <= MOST_IN_A_LEAF) {
            first[node] = from;
            count[node] = to - from;
            return;
        }
        axis[node] = (byte) longestAxis(centres);
        int middle = split(from, to, axis[node], centres, depth);
        first[node] = nodes;
        nodes += 2;
        build(first[node], from, middle, depth + 1);
        build(first[node] + 1, middle, to, depth + 1);
    }

    private static int longestAxis(double[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    /** Parts the items of a node in two and returns where the second part begins; neither is empty. */
    private int split(int from, int to, int axis, double[] centres, int depth) {
        double low = centres[axis];
        double scale = BINS / (centres[3 + axis] - low);
        if (depth >= GREATEST_SAH_DEPTH || Double.isInfinite(scale) || Double.isNaN(scale)) {
            return (from + to) / 2;
        }
        int border = bestBorder(from, to, axis, low, scale);
        int middle = from;
        for (int i = from; i < to; i++) {
            if (bin(order[i], axis, low, scale) < border) {
                int item = order[i];
                order[i] = order[middle];
                order[middle++] = item;
            }
        }
        return middle;
    }

    /** The number of the bin with which the second part is to begin: the sum of area x items is least there. */
    private int bestBorder(int from, int to, int axis, double low, double scale) {
        double[][] bins = new double[BINS][];
        int[] counts = new int[BINS];
        for (int i = from; i < to; i++) {
            int bin = bin(order[i], axis, low, scale);
            if (bins[bin] == null) {
                bins[bin] = emptyBox();
            }
            grow(bins[bin], itemBoxes, 6 * order[i]);
            counts[bin]++;
        }
        double[] costAbove = new double[BINS];
        double[] above = emptyBox();
        int countAbove = 0;
        for (int b = BINS - 1; b > 0; b--) {
            if (bins[b] != null) {
                grow(above, bins[b], 0);
                countAbove += counts[b];
            }
            costAbove[b] = countAbove == 0 ? Double.POSITIVE_INFINITY : area(above) * countAbove;
        }
        double[] below = emptyBox();
        int countBelow = 0;
        int best = 1;
        double least = Double.POSITIVE_INFINITY;
        for (int b = 1; b < BINS; b++) {
            if (bins[b - 1] != null) {
                grow(below, bins[b - 1], 0);
                countBelow += counts[b - 1];
            }
            double cost = area(below) * countBelow + costAbove[b];
            if (cost < least) {
                least = cost;
                best = b;
            }
        }
        return best;
    }

    private int bin(int item, int axis, double low, double scale) {
        return Math.min(BINS - 1, (int) ((centre(item, axis) - low) * scale));
    }

    /** Twice the middle of an item's box along an axis, which does as well. */
    private double centre(int item, int axis) {
        return itemBoxes[6 * item + axis] + itemBoxes[6 * item + 3 + axis];
    }

    private static double[] emptyBox() {
        double most = Double.POSITIVE_INFINITY;
        return new double[] {most, most, most, -most, -most, -most};
    }

    private static void grow(double[] box, double[] by, int at) {
        for (int k = 0; k < 3; k++) {
            box[k] = Math.min(box[k], by[at + k]);
            box[3 + k] = Math.max(box[3 + k], by[at + 3 + k]);
        }
    }

    private static double area(double[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return x * y + y * z + z * x;
    }
}
