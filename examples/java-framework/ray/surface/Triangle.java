package ray.surface;

import ray.IntersectionRecord;
import ray.Ray;
import ray.math.Point3;
import ray.math.Vector3;

/** One triangle of a mesh. */
public class Triangle extends Surface {

    final Mesh owner;
    final int[] index;

    Triangle(Mesh owner, int[] index) {
        this.owner = owner;
        this.index = index;
    }

    /**
     * The corners are taken to a space in which the ray is the z axis, by a shear that depends on the ray alone. There
     * the ray's side of an edge is the sign of one difference of products, the same but for its sign for both triangles
     * at the edge, and rounding makes no wrong sign of it, only a zero, which counts as inside of both: no ray slips
     * between two triangles [Woop 2013].
     */
    @Override
    public boolean intersect(IntersectionRecord record, Ray ray) {
        Ray object = untransformRay(ray);
        Vector3 d = object.direction;
        int kz = Math.abs(d.x) > Math.abs(d.y) ? 0 : 1;
        kz = Math.abs(d.z) > Math.abs(d.get(kz)) ? 2 : kz;
        int kx = (kz + 1) % 3;
        int ky = (kz + 2) % 3;
        double shearX = d.get(kx) / d.get(kz);
        double shearY = d.get(ky) / d.get(kz);
        double[] x = new double[3];
        double[] y = new double[3];
        double[] z = new double[3];
        for (int i = 0; i < 3; i++) {
            Vector3 corner = new Vector3();
            corner.sub(owner.getVertex(index[i]), object.origin);
            x[i] = corner.get(kx) - shearX * corner.get(kz);
            y[i] = corner.get(ky) - shearY * corner.get(kz);
            z[i] = corner.get(kz) / d.get(kz);
        }
        double u = x[2] * y[1] - y[2] * x[1];
        double v = x[0] * y[2] - y[0] * x[2];
        double w = x[1] * y[0] - y[1] * x[0];
        double sum = u + v + w;
        if (Math.min(u, Math.min(v, w)) < 0 && Math.max(u, Math.max(v, w)) > 0 || sum == 0) {
            return false;
        }
        double t = (u * z[0] + v * z[1] + w * z[2]) / sum;
        if (!(t >= ray.start && t <= ray.end)) {
            return false;
        }
        return report(record, ray, t, normal(u / sum, v / sum, w / sum));
    }

    private Vector3 normal(double u, double v, double w) {
        Vector3 normal = new Vector3();
        if (owner.existsNormals()) {
            normal.scaleAdd(u, owner.getNormal(index[0]));
            normal.scaleAdd(v, owner.getNormal(index[1]));
            normal.scaleAdd(w, owner.getNormal(index[2]));
            return normal;
        }
        Vector3 one = new Vector3();
        Vector3 other = new Vector3();
        one.sub(owner.getVertex(index[1]), owner.getVertex(index[0]));
        other.sub(owner.getVertex(index[2]), owner.getVertex(index[0]));
        normal.cross(one, other);
        return normal;
    }

    @Override
    public void computeBoundingBox() {
        Point3 min = new Point3();
        Point3 max = new Point3();
        min.set(owner.vertexMin(index[0]));
        max.set(owner.vertexMax(index[0]));
        for (int i = 1; i < 3; i++) {
            Point3 low = owner.vertexMin(index[i]);
            Point3 high = owner.vertexMax(index[i]);
            min.set(Math.min(min.x, low.x), Math.min(min.y, low.y), Math.min(min.z, low.z));
            max.set(Math.max(max.x, high.x), Math.max(max.y, high.y), Math.max(max.z, high.z));
        }
        setBox(min, max);
    }
}
