package ray.accel;

import ray.Hit;
import ray.math.Ray;
import ray.math.Vector3;

/**
 * A hierarchy of boxes along the axes over things that are known by a number and a box: the shapes of a scene, or the
 * triangles of a mesh. A node's box is six numbers, its smallest x, y, z and its largest.
 */
public final class Bvh {

    /** Something that can be hit, by its number. */
    public interface Items {
        void intersect(int item, Ray ray, Hit hit);
    }

    /** More than the depth of any tree that BvhBuilder makes. */
    private static final int STACK_SIZE = 128;

    private final BvhBuilder tree;
    private final Items items;

    /** @param boxes six numbers for each item */
    public Bvh(double[] boxes, Items items) {
        this.tree = new BvhBuilder(boxes);
        this.items = items;
    }

    /** Offers the hit all items whose boxes the ray meets before it; those on the near side first. */
    public void intersect(Ray ray, Hit hit) {
        Vector3 d = ray.direction;
        Vector3 inverse = new Vector3(1 / d.x, 1 / d.y, 1 / d.z);
        int[] stack = new int[STACK_SIZE];
        int size = tree.isEmpty() ? 0 : 1;
        while (size > 0 && !hit.isEnough()) {
            int node = stack[--size];
            if (!meets(node, ray, inverse, hit)) {
                continue;
            }
            int first = tree.first[node];
            if (tree.isLeaf(node)) {
                for (int i = first; i < first + tree.count[node]; i++) {
                    items.intersect(tree.order[i], ray, hit);
                }
            } else {
                int axis = tree.axis[node];
                int near = (axis == 0 ? d.x : axis == 1 ? d.y : d.z) < 0 ? 1 : 0;
                stack[size++] = first + 1 - near;
                stack[size++] = first + near;
            }
        }
    }

    /**
     * Whether the ray meets the box of a node no later than the hit. If the ray runs within a face, 0 times infinity
     * is not a number; no comparison with that is true, so the face does not count.
     */
    private boolean meets(int node, Ray ray, Vector3 inverse, Hit hit) {
        double[] box = tree.boxes;
        int at = 6 * node;
        double start = ray.tMin;
        double end = Math.min(ray.tMax, hit.t);
        int flip = inverse.x < 0 ? 3 : 0;
        double near = (box[at + flip] - ray.origin.x) * inverse.x;
        double far = (box[at + 3 - flip] - ray.origin.x) * inverse.x;
        start = near > start ? near : start;
        end = far < end ? far : end;
        flip = inverse.y < 0 ? 3 : 0;
        near = (box[at + 1 + flip] - ray.origin.y) * inverse.y;
        far = (box[at + 4 - flip] - ray.origin.y) * inverse.y;
        start = near > start ? near : start;
        end = far < end ? far : end;
        flip = inverse.z < 0 ? 3 : 0;
        near = (box[at + 2 + flip] - ray.origin.z) * inverse.z;
        far = (box[at + 5 - flip] - ray.origin.z) * inverse.z;
        start = near > start ? near : start;
        end = far < end ? far : end;
        return start <= end;
    }
}
