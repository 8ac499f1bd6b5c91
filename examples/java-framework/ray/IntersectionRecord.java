package ray;

import ray.math.Point3;
import ray.math.Vector3;
import ray.surface.Surface;

/** Where a ray meets a surface; in world space. */
public class IntersectionRecord {

    public final Point3 location = new Point3();
    public final Vector3 normal = new Vector3();
    public Surface surface;
    public double t;

    public void set(IntersectionRecord o) {
        location.set(o.location);
        normal.set(o.normal);
        surface = o.surface;
        t = o.t;
    }
}
