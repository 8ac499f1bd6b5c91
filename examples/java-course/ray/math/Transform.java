package ray.math;

/** An affine transformation: three rows of four numbers. */
public final class Transform {

    public static final Transform IDENTITY = scaling(new Vec(1, 1, 1));

    private final double[][] m;

    private Transform(double[][] m) {
        this.m = m;
    }

    public static Transform translation(Vec v) {
        return new Transform(new double[][] {{1, 0, 0, v.x}, {0, 1, 0, v.y}, {0, 0, 1, v.z}});
    }

    public static Transform scaling(Vec v) {
        return new Transform(new double[][] {{v.x, 0, 0, 0}, {0, v.y, 0, 0}, {0, 0, v.z, 0}});
    }

    /** About axis 0, 1 or 2, in degrees. */
    public static Transform rotation(int axis, double degrees) {
        double c = Math.cos(Math.toRadians(degrees));
        double s = Math.sin(Math.toRadians(degrees));
        int j = (axis + 1) % 3;
        int k = (axis + 2) % 3;
        double[][] r = new double[3][4];
        r[axis][axis] = 1;
        r[j][j] = c;
        r[j][k] = -s;
        r[k][j] = s;
        r[k][k] = c;
        return new Transform(r);
    }

    /** This transformation after the other one. */
    public Transform times(Transform o) {
        double[][] r = new double[3][4];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 4; j++) {
                r[i][j] = j == 3 ? m[i][3] : 0;
                for (int k = 0; k < 3; k++) {
                    r[i][j] += m[i][k] * o.m[k][j];
                }
            }
        }
        return new Transform(r);
    }

    public Transform inverse() {
        Vec a = new Vec(m[0][0], m[0][1], m[0][2]);
        Vec b = new Vec(m[1][0], m[1][1], m[1][2]);
        Vec c = new Vec(m[2][0], m[2][1], m[2][2]);
        double determinant = a.dot(b.cross(c));
        if (determinant == 0) {
            throw new IllegalArgumentException("a transformation cannot be inverted");
        }
        Vec[] columns = {b.cross(c), c.cross(a), a.cross(b)};
        double[][] r = new double[3][4];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                r[i][j] = columns[j].get(i) / determinant;
            }
            r[i][3] = -(r[i][0] * m[0][3] + r[i][1] * m[1][3] + r[i][2] * m[2][3]);
        }
        return new Transform(r);
    }

    public Vec vector(Vec v) {
        return new Vec(m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
                m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
                m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z);
    }

    public Vec point(Vec p) {
        Vec v = vector(p);
        return new Vec(v.x + m[0][3], v.y + m[1][3], v.z + m[2][3]);
    }

    /** The transpose's vector: what carries normals, if this is the inverse. */
    public Vec transposedVector(Vec v) {
        return new Vec(m[0][0] * v.x + m[1][0] * v.y + m[2][0] * v.z,
                m[0][1] * v.x + m[1][1] * v.y + m[2][1] * v.z,
                m[0][2] * v.x + m[1][2] * v.y + m[2][2] * v.z);
    }
}
