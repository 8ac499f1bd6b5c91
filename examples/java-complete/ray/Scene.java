package ray;

import java.util.ArrayList;
import java.util.List;

import ray.accel.Bvh;
import ray.math.Color;
import ray.math.Matrix4;
import ray.math.Ray;
import ray.math.Vector3;
import ray.shader.Lambertian;
import ray.shader.Shader;
import ray.shader.ShadingPoint;
import ray.surface.Instance;
import ray.surface.Surface;

/** Everything between &lt;scene&gt; and &lt;/scene&gt;, and what a ray sees of it. */
public class Scene {

    private Camera camera = new Camera();
    private int[] imageSize;
    private int samples = 1;
    private int maxDepth = 12;
    private double minContribution = 0.01;
    private final List<Light> lights = new ArrayList<>();
    private final List<Instance> instances = new ArrayList<>();
    private Bvh hierarchy;

    public void setCamera(Camera camera) {
        this.camera = camera;
    }

    /** Width and height in pixels. */
    public void setImage(int[] size) {
        if (size.length != 2 || size[0] < 1 || size[1] < 1) {
            throw new IllegalArgumentException("the image needs a width and a height");
        }
        imageSize = size;
    }

    public void setSamples(int samples) {
        if (samples < 0) {
            throw new IllegalArgumentException("the number of samples is negative");
        }
        this.samples = samples;
    }

    public void setMaxDepth(int depth) {
        if (depth < 1) {
            throw new IllegalArgumentException("maxDepth must be at least 1");
        }
        maxDepth = depth;
    }

    public void setMinContribution(double contribution) {
        if (contribution < 0) {
            throw new IllegalArgumentException("minContribution is negative");
        }
        minContribution = contribution;
    }

    public void addLight(Light light) {
        lights.add(light);
    }

    /** A shader that stands alone is only there to be referred to by its name. */
    public void addShader(Shader shader) {
    }

    public void addSurface(Surface surface) {
        surface.place(Matrix4.IDENTITY, new Lambertian(), instances);
    }

    /** Called by the parser when all has been set. */
    public void check() {
        if (imageSize == null) {
            throw new IllegalArgumentException("the scene has no <image>");
        }
        double[] boxes = new double[6 * instances.size()];
        for (Instance instance : instances) {
            instance.bounds().store(boxes, instance.index);
        }
        hierarchy = new Bvh(boxes, (item, ray, hit) -> instances.get(item).intersect(ray, hit));
    }

    public Camera camera() {
        return camera;
    }

    public Image newImage() {
        return new Image(imageSize[0], imageSize[1]);
    }

    /** How many samples a pixel has along each of its edges. */
    public int samplesAlongAnEdge() {
        return Math.max(1, (int) Math.round(Math.sqrt(samples)));
    }

    public List<Light> lights() {
        return lights;
    }

    /**
     * The colour that comes back along a ray.
     *
     * @param depth 1 for a ray from the camera, one more after each reflection or refraction
     * @param contribution how much of the colour counts for the pixel
     */
    public Color trace(Ray ray, int depth, double contribution) {
        if (depth > maxDepth || contribution < minContribution) {
            return Color.BLACK;
        }
        Hit hit = new Hit(false);
        hierarchy.intersect(ray, hit);
        if (hit.instance == null) {
            return Color.BLACK;
        }
        Vector3 toViewer = ray.direction.negated().unit();
        return hit.instance.shader.shade(this,
                new ShadingPoint(ray.at(hit.t), hit.instance.normal(ray, hit), toViewer, depth, contribution));
    }

    /** Whether anything, be it clear as glass, stands between a point and a light. */
    public boolean isInShadow(Vector3 point, Light light) {
        Hit hit = new Hit(true);
        hierarchy.intersect(new Ray(point, light.position().minus(point), Ray.EPSILON, 1), hit);
        return hit.instance != null;
    }
}
