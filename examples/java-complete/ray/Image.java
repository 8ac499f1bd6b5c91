package ray;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;

import javax.imageio.ImageIO;

import ray.math.Color;

/** The pixels of a picture, and how they become a PNG file. */
public class Image {

    private static final double GAMMA = 2.2;

    public final int width;
    public final int height;
    private final BufferedImage pixels;

    public Image(int width, int height) {
        this.width = width;
        this.height = height;
        pixels = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    }

    /** Sets a pixel to a linear colour; y counts from the bottom. */
    public void setPixel(int x, int y, Color color) {
        pixels.setRGB(x, height - 1 - y, level(color.r) << 16 | level(color.g) << 8 | level(color.b));
    }

    /** 0 to 255. The framework kept its pixels as floats, which sometimes decides how a level is rounded. */
    private static int level(double linear) {
        float encoded = (float) Math.max(0, Math.min(1, Math.pow(linear, 1 / GAMMA)));
        return (int) Math.floor(255.0 * encoded + 0.5);
    }

    public void write(File file) throws IOException {
        if (!ImageIO.write(pixels, "png", file)) {
            throw new IOException(file + ": cannot be written");
        }
    }
}
