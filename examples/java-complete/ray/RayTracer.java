package ray;

import java.io.File;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import ray.math.Color;

/**
 * The main program. Each argument is a scene file, or a folder whose *.xml are meant; the picture of scene.xml is
 * written beside it as scene.xml.png. The exit status is 1 if there was a scene without a picture.
 */
public class RayTracer {

    public static void main(String[] args) {
        List<File> scenes = new ArrayList<>();
        for (String path : args) {
            addScenes(new File(path), scenes);
        }
        if (scenes.isEmpty()) {
            System.err.println("usage: java ray.RayTracer (scene.xml | folder)...");
        }
        boolean allRight = !scenes.isEmpty();
        for (File file : scenes) {
            allRight &= render(file);
        }
        System.exit(allRight ? 0 : 1);
    }

    private static void addScenes(File path, List<File> scenes) {
        File[] inside = path.listFiles((folder, name) -> name.endsWith(".xml"));
        if (inside == null) {
            scenes.add(path);
            return;
        }
        Arrays.sort(inside);
        scenes.addAll(Arrays.asList(inside));
    }

    private static boolean render(File file) {
        try {
            renderImage(new Parser(file).parse()).write(new File(file.getPath() + ".png"));
            return true;
        } catch (Exception e) {
            System.err.println(file + ": " + (e.getMessage() == null ? e : e.getMessage()));
            return false;
        }
    }

    static Image renderImage(Scene scene) {
        Image image = scene.newImage();
        for (int y = 0; y < image.height; y++) {
            for (int x = 0; x < image.width; x++) {
                image.setPixel(x, y, renderPixel(scene, image, x, y));
            }
        }
        return image;
    }

    /** The mean, in linear light, of samples at the centres of a regular grid in the pixel. */
    private static Color renderPixel(Scene scene, Image image, int x, int y) {
        int n = scene.samplesAlongAnEdge();
        Color sum = Color.BLACK;
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                double u = (x + (i + 0.5) / n) / image.width;
                double v = (y + (j + 0.5) / n) / image.height;
                sum = sum.plus(scene.trace(scene.camera().getRay(u, v), 1, 1));
            }
        }
        return sum.times(1.0 / (n * n));
    }
}
