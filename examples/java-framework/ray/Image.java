package ray;

/** The size of the picture. */
public class Image {

    public final int width;
    public final int height;

    public Image(int width, int height) {
        if (width <= 0 || height <= 0) {
            throw new IllegalArgumentException("a picture needs a width and a height");
        }
        this.width = width;
        this.height = height;
    }
}
