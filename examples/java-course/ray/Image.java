package ray;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;

import javax.imageio.ImageIO;

import ray.math.Vec;

/** A picture in linear light, and how it becomes a PNG file. */
public class Image {

    public final int width;
    public final int height;
    private final float[] data;

    public Image(int width, int height) {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("the image has no pixels");
        }
        this.width = width;
        this.height = height;
        data = new float[3 * width * height];
    }

    /** Used by the parser: "640 480". */
    public static Image parse(String text) {
        String[] words = text.trim().split("\\s+");
        if (words.length != 2) {
            throw new IllegalArgumentException("<image> needs two numbers");
        }
        return new Image(Integer.parseInt(words[0]), Integer.parseInt(words[1]));
    }

    /** Row 0 is the bottom one. */
    public void setPixel(int x, int y, Vec color) {
        int at = 3 * (y * width + x);
        data[at] = encode(color.x);
        data[at + 1] = encode(color.y);
        data[at + 2] = encode(color.z);
    }

    private static float encode(double linear) {
        return (float) Math.max(0, Math.min(1, Math.pow(linear, 1 / 2.2)));
    }

    public void write(File file) throws IOException {
        BufferedImage out = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int rgb = 0;
                for (int k = 0; k < 3; k++) {
                    rgb = rgb << 8 | (int) Math.floor(255.0 * data[3 * (y * width + x) + k] + 0.5);
                }
                out.setRGB(x, height - 1 - y, rgb);
            }
        }
        if (!ImageIO.write(out, "png", file)) {
            throw new IOException("cannot write " + file);
        }
    }
}
