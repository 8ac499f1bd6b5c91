package ray.math;

/** An affine transformation. The last row of its 4x4 matrix is always 0 0 0 1 and so is not stored. */
public final class Matrix4 {

    public static final Matrix4 IDENTITY = scale(new Vector3(1, 1, 1));

    /** Three rows of four. */
    private final double[] m;

    private Matrix4(double... m) {
        this.m = m;
    }

    public static Matrix4 translate(Vector3 by) {
        return new Matrix4(1, 0, 0, by.x, 0, 1, 0, by.y, 0, 0, 1, by.z);
    }

    public static Matrix4 scale(Vector3 by) {
        return new Matrix4(by.x, 0, 0, 0, 0, by.y, 0, 0, 0, 0, by.z, 0);
    }

    public static Matrix4 rotateX(double degrees) {
        double c = Math.cos(Math.toRadians(degrees));
        double s = Math.sin(Math.toRadians(degrees));
        return new Matrix4(1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0);
    }

    public static Matrix4 rotateY(double degrees) {
        double c = Math.cos(Math.toRadians(degrees));
        double s = Math.sin(Math.toRadians(degrees));
        return new Matrix4(c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0);
    }

    public static Matrix4 rotateZ(double degrees) {
        double c = Math.cos(Math.toRadians(degrees));
        double s = Math.sin(Math.toRadians(degrees));
        return new Matrix4(c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0);
    }

    /** First the other, then this one. */
    public Matrix4 times(Matrix4 o) {
        double[] product = new double[12];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 4; column++) {
                double sum = column == 3 ? m[4 * row + 3] : 0;
                for (int k = 0; k < 3; k++) {
                    sum += m[4 * row + k] * o.m[4 * k + column];
                }
                product[4 * row + column] = sum;
            }
        }
        return new Matrix4(product);
    }

    /** By cofactors of the linear part. */
    public Matrix4 inverse() {
        Vector3 r0 = new Vector3(m[0], m[1], m[2]);
        Vector3 r1 = new Vector3(m[4], m[5], m[6]);
        Vector3 r2 = new Vector3(m[8], m[9], m[10]);
        double determinant = r0.dot(r1.cross(r2));
        if (determinant == 0 || Double.isNaN(determinant)) {
            throw new IllegalArgumentException("a transformation flattens its members: it has no inverse");
        }
        Vector3 c0 = r1.cross(r2).times(1 / determinant);
        Vector3 c1 = r2.cross(r0).times(1 / determinant);
        Vector3 c2 = r0.cross(r1).times(1 / determinant);
        Matrix4 linear = new Matrix4(c0.x, c1.x, c2.x, 0, c0.y, c1.y, c2.y, 0, c0.z, c1.z, c2.z, 0);
        return linear.times(translate(new Vector3(-m[3], -m[7], -m[11])));
    }

    public Vector3 point(Vector3 p) {
        return new Vector3(m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
                m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
                m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]);
    }

    public Vector3 vector(Vector3 v) {
        return new Vector3(m[0] * v.x + m[1] * v.y + m[2] * v.z,
                m[4] * v.x + m[5] * v.y + m[6] * v.z,
                m[8] * v.x + m[9] * v.y + m[10] * v.z);
    }

    /** The vector by the transposed matrix: if this one goes to object space, it brings a normal back from there. */
    public Vector3 transposedVector(Vector3 n) {
        return new Vector3(m[0] * n.x + m[4] * n.y + m[8] * n.z,
                m[1] * n.x + m[5] * n.y + m[9] * n.z,
                m[2] * n.x + m[6] * n.y + m[10] * n.z);
    }
}
