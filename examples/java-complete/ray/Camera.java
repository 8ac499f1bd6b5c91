package ray;

import ray.math.Ray;
import ray.math.Vector3;

/** A pinhole camera. Its window need not be at right angles to the view. */
public class Camera {

    private Vector3 viewPoint = Vector3.ZERO;
    private Vector3 viewDir = new Vector3(0, 0, -1);
    private Vector3 viewUp = new Vector3(0, 1, 0);
    private Vector3 projNormal;
    private double projDistance = 1;
    private double viewWidth = 1;
    private double viewHeight = 1;

    // from the eye to the middle of the window, and unit vectors along its edges
    private Vector3 toCenter;
    private Vector3 across;
    private Vector3 upward;

    public Camera() {
        check();
    }

    public void setViewPoint(Vector3 p) {
        viewPoint = p;
    }

    public void setViewDir(Vector3 d) {
        viewDir = d;
    }

    public void setViewUp(Vector3 d) {
        viewUp = d;
    }

    public void setProjNormal(Vector3 n) {
        projNormal = n;
    }

    public void setProjDistance(double d) {
        projDistance = positive(d);
    }

    public void setViewWidth(double w) {
        viewWidth = positive(w);
    }

    public void setViewHeight(double h) {
        viewHeight = positive(h);
    }

    private static double positive(double size) {
        if (!(size > 0)) {
            throw new IllegalArgumentException(size + " must be greater than 0");
        }
        return size;
    }

    /** Called by the parser when all has been set. */
    public final void check() {
        Vector3 w = (projNormal == null ? viewDir : projNormal).unit();
        double cosine = w.dot(viewDir);
        w = cosine > 0 ? w.negated() : w;
        across = viewUp.cross(w).unit();
        upward = w.cross(across);
        if (cosine == 0 || across.length() == 0) {
            throw new IllegalArgumentException("the camera's viewDir, viewUp and projNormal do not span a window");
        }
        toCenter = viewDir.unit().times(projDistance);
    }

    /** The ray through a point of the window, whose lower left corner is (0,0) and whose upper right one is (1,1). */
    public Ray getRay(double u, double v) {
        return new Ray(viewPoint, toCenter.plus(across.times((u - 0.5) * viewWidth))
                .plus(upward.times((v - 0.5) * viewHeight)));
    }
}
