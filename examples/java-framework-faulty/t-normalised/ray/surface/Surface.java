package ray.surface;

import java.util.List;

import ray.IntersectionRecord;
import ray.Ray;
import ray.math.Matrix4;
import ray.math.Point3;
import ray.math.Vector3;
import ray.shader.Shader;

/** Something that rays meet, given in its own space and placed in the world by a transformation. */
public abstract class Surface {

    /** From object space to the world, the inverse, and the inverse's transpose, which carries normals. */
    protected Matrix4 tMat;
    protected Matrix4 tMatInv;
    protected Matrix4 tMatTInv;

    /** The corners of the box around the surface, and a point in it by which it is sorted; in the world. */
    protected Point3 minBound;
    protected Point3 maxBound;
    protected Point3 averagePosition;

    protected Shader shader = Shader.DEFAULT;

    public void setShader(Shader shader) {
        this.shader = shader;
    }

    public Shader getShader() {
        return shader;
    }

    public Point3 getMinBound() {
        return minBound;
    }

    public Point3 getMaxBound() {
        return maxBound;
    }

    public Point3 getAveragePosition() {
        return averagePosition;
    }

    public void setTransformation(Matrix4 toWorld, Matrix4 inverse, Matrix4 inverseTransposed) {
        tMat = toWorld;
        tMatInv = inverse;
        tMatTInv = inverseTransposed;
        computeBoundingBox();
    }

    /** The largest row sum of |tMat| |tMatInv|: what a unit in the last place may grow to on the way there and back. */
    public double getSpread() {
        double spread = 1;
        for (int i = 0; i < 3; i++) {
            double sum = 0;
            for (int j = 0; j < 9; j++) {
                sum += Math.abs(tMat.get(i, j / 3) * tMatInv.get(j / 3, j % 3));
            }
            spread = Math.max(spread, sum);
        }
        return spread;
    }

    /** The ray in object space. */
    protected Ray untransformRay(Ray ray) {
        Ray object = new Ray(ray.origin, ray.direction);
        object.start = ray.start;
        object.end = ray.end;
        tMatInv.transform(object.origin);
        tMatInv.transform(object.direction);
        object.direction.normalize();
        return object;
    }

    /** Fills in a hit of the world's ray from t and the normal in object space; true. */
    protected boolean report(IntersectionRecord record, Ray ray, double t, Vector3 normal) {
        record.t = t;
        record.surface = this;
        ray.evaluate(record.location, t);
        record.normal.set(normal);
        tMatTInv.transform(record.normal);
        record.normal.normalize();
        return true;
    }

    /** Sets the box, and its middle as the point to sort by. */
    protected void setBox(Point3 min, Point3 max) {
        minBound = min;
        maxBound = max;
        averagePosition = new Point3(min.x + (max.x - min.x) / 2, min.y + (max.y - min.y) / 2,
                min.z + (max.z - min.z) / 2);
    }

    /** Whether the ray meets this surface in its range; then the record has the hit with the smallest t. */
    public abstract boolean intersect(IntersectionRecord record, Ray ray);

    /** Sets minBound, maxBound and averagePosition by the transformation. */
    public abstract void computeBoundingBox();

    /** Adds what the hierarchy is built of. */
    public void appendRenderableSurfaces(List<Surface> list) {
        list.add(this);
    }
}
