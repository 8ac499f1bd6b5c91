package ray;

import ray.math.Point3;
import ray.math.Vector3;

/** A pinhole camera, as the file describes it; nothing is drawn here. */
public class Camera {

    protected Point3 viewPoint = new Point3();
    protected Vector3 viewDir = new Vector3(0, 0, -1);
    protected Vector3 viewUp = new Vector3(0, 1, 0);
    protected Vector3 projNormal;
    protected double projDistance = 1;
    protected double viewWidth = 1;
    protected double viewHeight = 1;

    public void setViewPoint(Point3 viewPoint) {
        this.viewPoint = viewPoint;
    }

    public void setViewDir(Vector3 viewDir) {
        this.viewDir = viewDir;
    }

    public void setViewUp(Vector3 viewUp) {
        this.viewUp = viewUp;
    }

    public void setProjNormal(Vector3 projNormal) {
        this.projNormal = projNormal;
    }

    public void setProjDistance(double projDistance) {
        this.projDistance = projDistance;
    }

    public void setViewWidth(double viewWidth) {
        this.viewWidth = viewWidth;
    }

    public void setViewHeight(double viewHeight) {
        this.viewHeight = viewHeight;
    }
}
