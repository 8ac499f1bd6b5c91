package ray.surface;

import java.util.ArrayList;
import java.util.List;

import ray.IntersectionRecord;
import ray.Ray;
import ray.math.Matrix4;
import ray.math.Vector3;

/** Surfaces that are transformed together. The transformation that is first in the file is the outermost. */
public class Group extends Surface {

    private final List<Surface> objs = new ArrayList<>();
    private final Matrix4 transformMat = new Matrix4();

    public void addSurface(Surface surface) {
        objs.add(surface);
    }

    public void setTranslate(Vector3 v) {
        Matrix4 step = new Matrix4();
        step.setTranslate(v);
        transformMat.rightCompose(step);
    }

    public void setScale(Vector3 v) {
        Matrix4 step = new Matrix4();
        step.setScale(v);
        transformMat.rightCompose(step);
    }

    /** Turns about x first, then y, then z: the turn about z is the outermost. */
    public void setRotate(Vector3 degrees) {
        Matrix4 step = new Matrix4();
        for (int axis = 2; axis >= 0; axis--) {
            step.setRotate(degrees.get(axis), axis);
            transformMat.rightCompose(step);
        }
    }

    @Override
    public void setTransformation(Matrix4 toWorld, Matrix4 inverse, Matrix4 inverseTransposed) {
        tMat = new Matrix4(toWorld);
        tMat.rightCompose(transformMat);
        tMatInv = new Matrix4(tMat);
        tMatInv.invert();
        tMatTInv = tMatInv.transposedLinear();
        for (Surface surface : objs) {
            surface.setTransformation(tMat, tMatInv, tMatTInv);
        }
    }

    @Override
    public boolean intersect(IntersectionRecord record, Ray ray) {
        throw new IllegalStateException("a group's members are intersected, not the group");
    }

    @Override
    public void computeBoundingBox() {
        // nothing is asked for the box of a group
    }

    @Override
    public void appendRenderableSurfaces(List<Surface> list) {
        for (Surface surface : objs) {
            surface.appendRenderableSurfaces(list);
        }
    }
}
