package ray;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;

import javax.imageio.ImageIO;

/**
 * A ray tracer for scenes of triangle meshes and spheres. How the nearest hit is found stands in Search.java.
 *
 * <pre>
 *   javac -encoding UTF-8 -d out (all .java files)
 *   java -Djava.awt.headless=true -cp out ray.RayTracer scene.xml ...
 * </pre>
 */
public class RayTracer {

    public static void main(String[] args) {
        int status = args.length == 0 ? 1 : 0;
        for (String path : args) {
            try {
                render(SceneReader.read(new File(path)), new File(path + ".png"));
            } catch (Exception e) {
                System.err.println(path + ": " + e);
                status = 1;
            }
        }
        System.exit(status);
    }

    private static void render(Scene scene, File file) throws IOException {
        BufferedImage image = new BufferedImage(scene.width, scene.height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < scene.height; y++) {
            for (int x = 0; x < scene.width; x++) {
                Ray ray = scene.camera.ray((x + 0.5) / scene.width, (y + 0.5) / scene.height);
                Vec color = scene.trace(ray);
                image.setRGB(x, scene.height - 1 - y, level(color.x) << 16 | level(color.y) << 8 | level(color.z));
            }
        }
        if (!ImageIO.write(image, "png", file)) {
            throw new IOException("cannot write " + file);
        }
    }

    private static int level(double linear) {
        float encoded = (float) Math.min(1, Math.pow(Math.max(0, linear), 1 / 2.2));
        return (int) Math.floor(255.0 * encoded + 0.5);
    }
}
