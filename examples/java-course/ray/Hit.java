package ray;

import ray.math.Ray;
import ray.math.Vec;
import ray.shader.Shader;

/** Where a ray meets a surface. */
public class Hit {

    public double t = Double.POSITIVE_INFINITY;
    public Vec normal;
    public Shader shader;

    /** Takes a root, if it is in the ray's range and nearer than the one before. */
    public boolean offer(Ray ray, double root, Vec n) {
        if (root >= ray.tMin && root <= ray.tMax && root < t) {
            t = root;
            normal = n;
            return true;
        }
        return false;
    }
}
