package ray;

import java.io.File;

import ray.math.Ray;
import ray.math.Vec;

/*
 * README
 *
 * PA 3, Advanced Ray Tracing. Handed in by Zoë Lindström and José Ibáñez.
 *
 *   javac -encoding ISO-8859-1 -d out (all .java files)
 *   java -Djava.awt.headless=true -cp out ray.RayTracer scene.xml ...
 *
 * Each argument is a scene; its picture is written beside it, as scene.xml.png. A scene that cannot
 * be read gives a message on stderr, no picture, and exit status 1. There is no cone.
 *
 * THIS EXAMPLE IS WRONG ON PURPOSE, in one place: Group.setRotate multiplies Rx Ry Rz instead of
 * Rz Ry Rx, so a rotation about more than one axis comes out differently.
 */
public class RayTracer {

    /** A ray that contributes less than this to its pixel is not traced. */
    static final double MIN_CONTRIBUTION = 0.01;

    /** The camera's ray has depth 1; a ray deeper than this is black. */
    static final int MAX_DEPTH = 12;

    public static void main(String[] args) {
        int status = args.length == 0 ? 1 : 0;
        for (String path : args) {
            try {
                Scene scene = (Scene) new Parser(new File(path)).parse();
                renderImage(scene);
                scene.image.write(new File(path + ".png"));
            } catch (Exception e) {
                System.err.println(path + ": " + e.getMessage());
                status = 1;
            }
        }
        System.exit(status);
    }

    static void renderImage(Scene scene) {
        Image image = scene.image;
        int n = Math.max(1, (int) Math.round(Math.sqrt(scene.samples)));
        for (int y = 0; y < image.height; y++) {
            for (int x = 0; x < image.width; x++) {
                Vec sum = Vec.ZERO;
                for (int j = 0; j < n; j++) {
                    for (int i = 0; i < n; i++) {
                        Ray ray = scene.camera.getRay((x + (i + 0.5) / n) / image.width,
                                (y + (j + 0.5) / n) / image.height);
                        System.out.println("shooting ray " + x + " " + y);
                        sum = sum.add(shadeRay(scene, ray, 1, 1));
                    }
                }
                image.setPixel(x, y, sum.scale(1.0 / (n * n)));
            }
        }
    }

    /** The colour that comes back along a ray. */
    public static Vec shadeRay(Scene scene, Ray ray, int depth, double contribution) {
        if (depth > MAX_DEPTH || contribution < MIN_CONTRIBUTION) {
            return Vec.ZERO;
        }
        Hit hit = scene.firstHit(ray);
        if (hit == null) {
            return Vec.ZERO;
        }
        Vec point = ray.at(hit.t);
        Vec toEye = ray.direction.negate().unit();
        return hit.shader.shade(scene, point, hit.normal, toEye, depth, contribution);
    }
}
