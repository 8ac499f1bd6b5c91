package ray.math;

/** Linear red, green and blue. */
public class Color extends Tuple3 {

    public Color(double r, double g, double b) {
        super(r, g, b);
    }
}
