package ray;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** A bounding volume hierarchy, each node halved at the median. */
class Search {

    private static final int MOST_IN_A_LEAF = 4;

    private final Node root;

    Search(List<Surface> surfaces) {
        root = surfaces.isEmpty() ? null : new Node(new ArrayList<>(surfaces));
    }

    void closest(Ray ray, Hit hit) {
        if (root != null) {
            root.closest(ray, hit);
        }
    }

    private static class Node {

        private Box box;
        private List<Surface> leaf;
        private Node left;
        private Node right;
        private int axis;

        Node(List<Surface> list) {
            box = list.get(0).box();
            for (Surface surface : list) {
                box = box.union(surface.box());
            }
            Vec size = box.high.sub(box.low);
            double margin = 1e-9 * (1 + size.x + size.y + size.z);
            box.low = box.low.sub(new Vec(margin, margin, margin));
            box.high = box.high.add(new Vec(margin, margin, margin));
            if (list.size() <= MOST_IN_A_LEAF) {
                leaf = list;
                return;
            }
            axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            list.sort(Comparator.comparingDouble(s -> s.centre().get(axis)));
            int middle = list.size() / 2;
            left = new Node(new ArrayList<>(list.subList(0, middle)));
            right = new Node(new ArrayList<>(list.subList(middle, list.size())));
        }

        void closest(Ray ray, Hit hit) {
            if (!box.hit(ray, hit.t)) {
                return;
            }
            if (leaf != null) {
                for (Surface surface : leaf) {
                    surface.intersect(ray, hit);
                }
            } else if (ray.direction.get(axis) < 0) {
                right.closest(ray, hit);
                left.closest(ray, hit);
            } else {
                left.closest(ray, hit);
                right.closest(ray, hit);
            }
        }
    }
}
