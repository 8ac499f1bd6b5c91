package ray.surface;

import java.util.Arrays;
import java.util.Comparator;

import ray.Hit;
import ray.math.Ray;
import ray.math.Vec;

/** A node of a mesh's tree: a box around a few triangles, or around two smaller nodes. */
class MeshNode {

    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private Integer[] leaf;
    private MeshNode left;
    private MeshNode right;

    static MeshNode build(Mesh mesh) {
        Integer[] all = new Integer[mesh.triangles.length / 3];
        for (int i = 0; i < all.length; i++) {
            all[i] = i;
        }
        return new MeshNode(mesh, all);
    }

    private MeshNode(Mesh mesh, Integer[] list) {
        int longest = 0;
        for (int k = 0; k < 3; k++) {
            low[k] = Double.POSITIVE_INFINITY;
            high[k] = Double.NEGATIVE_INFINITY;
            for (int triangle : list) {
                for (int corner = 0; corner < 3; corner++) {
                    double x = mesh.vertices[mesh.triangles[3 * triangle + corner]].get(k);
                    low[k] = Math.min(low[k], x);
                    high[k] = Math.max(high[k], x);
                }
            }
            double margin = 1e-9 * (1 + high[k] - low[k]);
            low[k] -= margin;
            high[k] += margin;
            if (high[k] - low[k] > high[longest] - low[longest]) {
                longest = k;
            }
        }
        if (list.length <= 4) {
            leaf = list;
            return;
        }
        int axis = longest;
        Arrays.sort(list, Comparator.comparingDouble(i -> centre(mesh, i, axis)));
        left = new MeshNode(mesh, Arrays.copyOfRange(list, 0, list.length / 2));
        right = new MeshNode(mesh, Arrays.copyOfRange(list, list.length / 2, list.length));
    }

    private static double centre(Mesh mesh, int triangle, int axis) {
        Vec a = mesh.vertices[mesh.triangles[3 * triangle]];
        Vec b = mesh.vertices[mesh.triangles[3 * triangle + 1]];
        Vec c = mesh.vertices[mesh.triangles[3 * triangle + 2]];
        return a.get(axis) + b.get(axis) + c.get(axis);
    }

    boolean intersect(Mesh mesh, Ray ray, Hit hit) {
        double start = ray.tMin;
        double end = Math.min(ray.tMax, hit.t);
        for (int k = 0; k < 3; k++) {
            double o = ray.origin.get(k);
            double d = ray.direction.get(k);
            if (d == 0 && (o < low[k] || o > high[k])) {
                return false;
            }
            if (d != 0) {
                start = Math.max(start, Math.min((low[k] - o) / d, (high[k] - o) / d));
                end = Math.min(end, Math.max((low[k] - o) / d, (high[k] - o) / d));
            }
        }
        if (start > end) {
            return false;
        }
        boolean found = false;
        if (leaf == null) {
            found = left.intersect(mesh, ray, hit);
            return right.intersect(mesh, ray, hit) || found;
        }
        for (int triangle : leaf) {
            found |= mesh.intersectTriangle(triangle, ray, hit);
        }
        return found;
    }
}
