package ray;

import ray.math.Ray;
import ray.math.Vec;

/** A pinhole camera; its projection plane may be oblique. */
public class Camera {

    private Vec viewPoint = Vec.ZERO;
    private Vec viewDir = new Vec(0, 0, -1);
    private Vec viewUp = new Vec(0, 1, 0);
    private Vec projNormal;
    private double projDistance = 1;
    private double viewWidth = 1;
    private double viewHeight = 1;
    private Vec u;
    private Vec v;

    public void setViewPoint(Vec p) {
        viewPoint = p;
    }

    public void setViewDir(Vec d) {
        viewDir = d;
    }

    public void setViewUp(Vec d) {
        viewUp = d;
    }

    public void setProjNormal(Vec n) {
        projNormal = n;
    }

    public void setProjDistance(double d) {
        projDistance = d;
    }

    public void setViewWidth(double w) {
        viewWidth = w;
    }

    public void setViewHeight(double h) {
        viewHeight = h;
    }

    /** The ray through a point of the window; (0,0) is its lower left corner and (1,1) the other. */
    public Ray getRay(double s, double t) {
        if (u == null) {
            initView();
        }
        Vec direction = viewDir.unit().scale(projDistance).add(u.scale((s - 0.5) * viewWidth))
                .add(v.scale((t - 0.5) * viewHeight));
        return new Ray(viewPoint, direction.unit());
    }

    private void initView() {
        Vec w = (projNormal == null ? viewDir : projNormal).unit();
        double cosine = w.dot(viewDir);
        if (cosine > 0) {
            w = w.negate();
        }
        if (cosine == 0 || viewUp.cross(w).length() == 0) {
            throw new IllegalArgumentException("the camera's vectors do not span a window");
        }
        u = viewUp.cross(w).unit();
        v = w.cross(u);
    }
}
