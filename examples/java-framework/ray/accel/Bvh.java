package ray.accel;

import java.util.Arrays;
import java.util.Comparator;

import ray.IntersectionRecord;
import ray.Ray;
import ray.surface.Surface;

/** A tree of boxes, split in the middle of the longest axis. Of two hits at the same t, the earlier surface counts. */
public class Bvh implements AccelStruct {

    private static final int LEAF_SIZE = 4;

    private Surface[] surfaces = {};
    private Integer[] order = {};
    private Node root;

    private final class Node {
        final double[] low = new double[3];
        final double[] high = new double[3];
        /** What the rounding of a ray that is taken to object space may amount to, in units of the last place. */
        double spread = 1;
        final int from;
        final int to;
        Node left;
        Node right;

        Node(int from, int to) {
            this.from = from;
            this.to = to;
            int longest = 0;
            for (int i = 0; i < 3; i++) {
                low[i] = Double.POSITIVE_INFINITY;
                high[i] = Double.NEGATIVE_INFINITY;
                for (int j = from; j < to; j++) {
                    low[i] = Math.min(low[i], surfaces[order[j]].getMinBound().get(i));
                    high[i] = Math.max(high[i], surfaces[order[j]].getMaxBound().get(i));
                    spread = Math.max(spread, surfaces[order[j]].getSpread());
                }
                if (high[i] - low[i] > high[longest] - low[longest]) {
                    longest = i;
                }
            }
            if (to - from <= LEAF_SIZE) {
                return;
            }
            int axis = longest;
            Arrays.sort(order, from, to, Comparator.comparingDouble(k -> surfaces[k].getAveragePosition().get(axis)));
            left = new Node(from, (from + to) / 2);
            right = new Node((from + to) / 2, to);
        }

        /**
         * Whether the ray may meet the box. The box is widened by 64 units in the last place of what goes into a hit's
         * place, times the spread: that covers the slabs' own rounding too. A NaN of 0 * infinity changes nothing, for
         * comparisons with it are false.
         */
        boolean isMet(Ray ray) {
            double near = ray.start;
            double far = ray.end;
            for (int i = 0; i < 3; i++) {
                double o = ray.origin.get(i);
                double largest = Math.max(Math.abs(o), Math.max(Math.abs(low[i]), Math.abs(high[i])));
                double margin = 64 * Math.ulp(1.0) * spread * largest;
                double inverse = 1 / ray.direction.get(i);
                double a = (low[i] - margin - o) * inverse;
                double b = (high[i] + margin - o) * inverse;
                double first = inverse < 0 ? b : a;
                double last = inverse < 0 ? a : b;
                if (first > near) {
                    near = first;
                }
                if (last < far) {
                    far = last;
                }
            }
            return near <= far;
        }
    }

    @Override
    public void build(Surface[] all) {
        surfaces = all.clone();
        order = new Integer[all.length];
        Arrays.setAll(order, i -> i);
        root = all.length == 0 ? null : new Node(0, all.length);
    }

    @Override
    public boolean intersect(IntersectionRecord record, Ray ray, boolean any) {
        Ray rest = new Ray(ray.origin, ray.direction);
        rest.start = ray.start;
        rest.end = ray.end;
        return root != null && search(root, record, rest, any, -1) >= 0;
    }

    /** The place of the best surface so far; the ray ends at its hit. */
    private int search(Node node, IntersectionRecord record, Ray ray, boolean any, int best) {
        if (any && best >= 0 || !node.isMet(ray)) {
            return best;
        }
        if (node.left != null) {
            return search(node.right, record, ray, any, search(node.left, record, ray, any, best));
        }
        IntersectionRecord one = new IntersectionRecord();
        for (int j = node.from; j < node.to; j++) {
            int k = order[j];
            if (surfaces[k].intersect(one, ray) && (best < 0 || one.t < record.t || one.t == record.t && k < best)) {
                record.set(one);
                ray.end = one.t;
                best = k;
            }
        }
        return best;
    }
}
