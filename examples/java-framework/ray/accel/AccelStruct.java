package ray.accel;

import ray.IntersectionRecord;
import ray.Ray;
import ray.surface.Surface;

/** Finds hits among many surfaces. */
public interface AccelStruct {

    void build(Surface[] surfaces);

    /** The first hit in the ray's range, or (any) whichever comes first to hand. */
    boolean intersect(IntersectionRecord record, Ray ray, boolean any);
}
