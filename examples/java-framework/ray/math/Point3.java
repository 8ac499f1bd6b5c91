package ray.math;

public class Point3 extends Tuple3 {

    public Point3() {
        super(0, 0, 0);
    }

    public Point3(double x, double y, double z) {
        super(x, y, z);
    }
}
