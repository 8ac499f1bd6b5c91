package ray;

/** A pinhole camera. */
public class Camera {

    private final Vec eye;
    private final Vec ahead;
    private final Vec right;
    private final Vec up;

    public Camera(Vec eye, Vec viewDir, Vec projNormal, Vec viewUp, double distance, double width, double height) {
        Vec w = projNormal.scale(projNormal.dot(viewDir) > 0 ? -1 : 1).unit();
        Vec u = viewUp.cross(w).unit();
        this.eye = eye;
        ahead = viewDir.unit().scale(distance);
        right = u.scale(width);
        up = w.cross(u).scale(height);
    }

    /** The ray through a point of the window; (0,0) is its lower left corner and (1,1) the other. */
    public Ray ray(double s, double t) {
        return new Ray(eye, ahead.add(right.scale(s - 0.5)).add(up.scale(t - 0.5)).unit());
    }
}
