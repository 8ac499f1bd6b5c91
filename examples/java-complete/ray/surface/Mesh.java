package ray.surface;

import java.io.File;
import java.io.IOException;

import ray.Hit;
import ray.accel.Bvh;
import ray.math.Bounds;
import ray.math.Ray;
import ray.math.Vector3;

/** A triangle mesh, smooth if its file has normals. Its triangles have a hierarchy of their own. */
public class Mesh extends Shape {

    private MeshFile data;
    private Bvh triangles;

    public void setData(File file) throws IOException {
        data = new MeshFile(file);
        int count = data.corners.length / 3;
        double[] boxes = new double[6 * count];
        for (int triangle = 0; triangle < count; triangle++) {
            Bounds bounds = new Bounds();
            for (int k = 0; k < 3; k++) {
                bounds.add(corner(data.vertices, triangle, k));
            }
            bounds.store(boxes, triangle);
        }
        triangles = new Bvh(boxes, this::intersectTriangle);
    }

    /** Called by the parser when all has been set. */
    public void check() {
        if (data == null) {
            throw new IllegalArgumentException("a mesh has no <data>");
        }
    }

    @Override
    public void intersect(Ray ray, Hit hit) {
        triangles.intersect(ray, hit);
    }

    /**
     * With the corners a, b, c seen from the origin of the ray, d (b x c) tells on which side of the edge b c
     * the ray passes. Both triangles of an edge come to the same number but for its sign, so no ray slips through
     * between them. The three numbers are also the weights of the corners, times their sum.
     */
    private void intersectTriangle(int triangle, Ray ray, Hit hit) {
        double[] v = data.vertices;
        int ia = 3 * data.corners[3 * triangle];
        int ib = 3 * data.corners[3 * triangle + 1];
        int ic = 3 * data.corners[3 * triangle + 2];
        Vector3 o = ray.origin;
        Vector3 d = ray.direction;
        double ax = v[ia] - o.x;
        double ay = v[ia + 1] - o.y;
        double az = v[ia + 2] - o.z;
        double bx = v[ib] - o.x;
        double by = v[ib + 1] - o.y;
        double bz = v[ib + 2] - o.z;
        double cx = v[ic] - o.x;
        double cy = v[ic + 1] - o.y;
        double cz = v[ic + 2] - o.z;
        double alpha = d.x * (by * cz - bz * cy) + d.y * (bz * cx - bx * cz) + d.z * (bx * cy - by * cx);
        double beta = d.x * (cy * az - cz * ay) + d.y * (cz * ax - cx * az) + d.z * (cx * ay - cy * ax);
        double gamma = d.x * (ay * bz - az * by) + d.y * (az * bx - ax * bz) + d.z * (ax * by - ay * bx);
        boolean inside = alpha >= 0 && beta >= 0 && gamma >= 0 || alpha <= 0 && beta <= 0 && gamma <= 0;
        double sum = alpha + beta + gamma;
        if (!inside || sum == 0) {
            return;
        }
        Vector3 n = flatNormal(triangle);
        double t = (n.x * ax + n.y * ay + n.z * az) / n.dot(d);
        if (hit.offer(ray, t, triangle)) {
            hit.beta = beta / sum;
            hit.gamma = gamma / sum;
        }
    }

    @Override
    public Vector3 normal(Hit hit, Vector3 point) {
        if (data.normals == null) {
            return flatNormal(hit.part);
        }
        return corner(data.normals, hit.part, 0).times(1 - hit.beta - hit.gamma)
                .plus(corner(data.normals, hit.part, 1).times(hit.beta))
                .plus(corner(data.normals, hit.part, 2).times(hit.gamma));
    }

    private Vector3 flatNormal(int triangle) {
        Vector3 a = corner(data.vertices, triangle, 0);
        return corner(data.vertices, triangle, 1).minus(a).cross(corner(data.vertices, triangle, 2).minus(a));
    }

    @Override
    public Bounds bounds() {
        Bounds bounds = new Bounds();
        for (int i = 0; i < data.corners.length; i++) {
            bounds.add(corner(data.vertices, i / 3, i % 3));
        }
        return bounds;
    }

    /** What a list has for a corner, 0 to 2, of a triangle: a vertex or a normal. */
    private Vector3 corner(double[] list, int triangle, int k) {
        int at = 3 * data.corners[3 * triangle + k];
        return new Vector3(list[at], list[at + 1], list[at + 2]);
    }
}
