package ray.math;

import java.math.BigDecimal;
import java.math.MathContext;

/** An affine transformation: three rows of four numbers over a last row that is always 0 0 0 1. */
public class Matrix4 {

    /** Of quotients, which are then rounded to the 16 of a double. */
    private static final MathContext DIGITS = new MathContext(60);

    private final double[][] m = new double[4][4];

    public Matrix4() {
        setIdentity();
    }

    public Matrix4(Matrix4 o) {
        set(o);
    }

    public double get(int row, int column) {
        return m[row][column];
    }

    private void put(int row, int column, double value) {
        m[row][column] = value;
    }

    public void set(Matrix4 o) {
        for (int i = 0; i < 16; i++) {
            put(i / 4, i % 4, o.get(i / 4, i % 4));
        }
    }

    public void setIdentity() {
        for (int i = 0; i < 16; i++) {
            put(i / 4, i % 4, i / 4 == i % 4 ? 1 : 0);
        }
    }

    public void setTranslate(Vector3 v) {
        setIdentity();
        for (int i = 0; i < 3; i++) {
            put(i, 3, v.get(i));
        }
    }

    public void setScale(Vector3 v) {
        setIdentity();
        for (int i = 0; i < 3; i++) {
            put(i, i, v.get(i));
        }
    }

    /** A turn about axis 0, 1 or 2. Whole turns are taken off first, which is exact, while radians are not. */
    public void setRotate(double degrees, int axis) {
        setIdentity();
        double radians = Math.toRadians(Math.IEEEremainder(degrees, 360));
        int j = (axis + 1) % 3;
        int k = (axis + 2) % 3;
        put(j, j, Math.cos(radians));
        put(k, k, Math.cos(radians));
        put(k, j, Math.sin(radians));
        put(j, k, -Math.sin(radians));
    }

    /** Sets this to itself after the other one: this = this * o. */
    public void rightCompose(Matrix4 o) {
        Matrix4 left = new Matrix4(this);
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 4; j++) {
                double sum = 0;
                for (int k = 0; k < 4; k++) {
                    sum += left.get(i, k) * o.get(k, j);
                }
                put(i, j, sum);
            }
        }
    }

    /** Inverts this; the cofactors are exact and the quotients rounded once. */
    public void invert() {
        BigDecimal[][] exact = new BigDecimal[3][4];
        for (int i = 0; i < 12; i++) {
            exact[i / 4][i % 4] = new BigDecimal(get(i / 4, i % 4));
        }
        BigDecimal[][] cofactors = new BigDecimal[3][3];
        for (int i = 0; i < 9; i++) {
            int r = i / 3;
            int c = i % 3;
            cofactors[r][c] = exact[(r + 1) % 3][(c + 1) % 3].multiply(exact[(r + 2) % 3][(c + 2) % 3])
                    .subtract(exact[(r + 1) % 3][(c + 2) % 3].multiply(exact[(r + 2) % 3][(c + 1) % 3]));
        }
        BigDecimal determinant = BigDecimal.ZERO;
        for (int c = 0; c < 3; c++) {
            determinant = determinant.add(exact[0][c].multiply(cofactors[0][c]));
        }
        if (determinant.signum() == 0) {
            throw new IllegalArgumentException("a transformation cannot be inverted");
        }
        for (int i = 0; i < 3; i++) {
            BigDecimal moved = BigDecimal.ZERO;
            for (int j = 0; j < 3; j++) {
                moved = moved.subtract(cofactors[j][i].multiply(exact[j][3]));
                put(i, j, cofactors[j][i].divide(determinant, DIGITS).doubleValue());
            }
            put(i, 3, moved.divide(determinant, DIGITS).doubleValue());
        }
    }

    /** The transpose of the linear part alone: what carries normals, if this is an inverse. */
    public Matrix4 transposedLinear() {
        Matrix4 result = new Matrix4();
        for (int i = 0; i < 9; i++) {
            result.put(i / 3, i % 3, get(i % 3, i / 3));
        }
        return result;
    }

    public void transform(Point3 p) {
        p.set(row(0, p) + get(0, 3), row(1, p) + get(1, 3), row(2, p) + get(2, 3));
    }

    public void transform(Vector3 v) {
        v.set(row(0, v), row(1, v), row(2, v));
    }

    private double row(int i, Tuple3 t) {
        return get(i, 0) * t.x + get(i, 1) * t.y + get(i, 2) * t.z;
    }
}
