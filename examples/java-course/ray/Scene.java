package ray;

import java.util.ArrayList;
import java.util.List;

import ray.math.Ray;
import ray.math.Transform;
import ray.math.Vec;
import ray.shader.Lambertian;
import ray.shader.Shader;
import ray.surface.Instance;
import ray.surface.Surface;

/** Everything between &lt;scene&gt; and &lt;/scene&gt;. */
public class Scene {

    public Camera camera = new Camera();
    public Image image;
    public int samples = 1;
    public final List<Light> lights = new ArrayList<>();
    private final List<Instance> instances = new ArrayList<>();

    public void setCamera(Camera camera) {
        this.camera = camera;
    }

    public void setImage(Image image) {
        this.image = image;
    }

    public void setSamples(int samples) {
        this.samples = samples;
    }

    public void addLight(Light light) {
        lights.add(light);
    }

    public void addShader(Shader shader) {
        // only named here, to be referred to later
    }

    public void addSurface(Surface surface) {
        surface.place(Transform.IDENTITY, new Lambertian(), instances);
    }

    /** Called by the parser when all has been read. */
    public void finish() {
        if (image == null) {
            throw new IllegalArgumentException("the scene has no <image>");
        }
    }

    /** The nearest hit with its normal in the world and its shader, or null. */
    public Hit firstHit(Ray ray) {
        Hit best = null;
        Instance found = null;
        for (Instance instance : instances) {
            Hit hit = new Hit();
            if (instance.intersect(ray, hit) && (best == null || hit.t < best.t)) {
                best = hit;
                found = instance;
            }
        }
        if (best != null) {
            best.normal = found.normalToWorld(best.normal);
            best.shader = found.shader;
        }
        return best;
    }

    /** Whether nothing stands between a point and a light. */
    public boolean sees(Vec point, Light light) {
        Ray ray = new Ray(point, light.position.sub(point), Ray.EPSILON, 1);
        for (Instance instance : instances) {
            if (instance.intersect(ray, new Hit())) {
                return false;
            }
        }
        return true;
    }
}
