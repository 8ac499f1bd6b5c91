package ray;

import java.util.ArrayList;
import java.util.List;

import ray.accel.AccelStruct;
import ray.accel.Bvh;
import ray.math.Matrix4;
import ray.shader.Shader;
import ray.surface.Surface;

/** Everything between &lt;scene&gt; and &lt;/scene&gt;. */
public class Scene {

    protected Camera camera = new Camera();
    protected Image image;
    protected int samples = 1;
    protected final List<Light> lights = new ArrayList<>();
    protected final List<Shader> shaders = new ArrayList<>();
    protected final List<Surface> surfaces = new ArrayList<>();
    protected AccelStruct accelStruct = new Bvh();

    public void setCamera(Camera camera) {
        this.camera = camera;
    }

    public Camera getCamera() {
        return camera;
    }

    public void setImage(Image image) {
        this.image = image;
    }

    public Image getImage() {
        return image;
    }

    public void setSamples(int samples) {
        this.samples = samples;
    }

    public void addLight(Light light) {
        lights.add(light);
    }

    public void addShader(Shader shader) {
        shaders.add(shader);
    }

    public void addSurface(Surface surface) {
        surfaces.add(surface);
    }

    public List<Surface> getSurfaces() {
        return surfaces;
    }

    public AccelStruct getAccelStruct() {
        return accelStruct;
    }

    /** Hands the transformations down the tree; each surface then knows its place and its box. */
    public void setTransform() {
        for (Surface surface : surfaces) {
            surface.setTransformation(new Matrix4(), new Matrix4(), new Matrix4());
        }
    }

    /** The hit with the smallest t in the ray's range; false, and the record is left alone, if there is none. */
    public boolean getFirstIntersection(IntersectionRecord record, Ray ray) {
        return accelStruct.intersect(record, ray, false);
    }

    /** Whether anything lies in the ray's range. */
    public boolean getAnyIntersection(Ray ray) {
        return accelStruct.intersect(new IntersectionRecord(), ray, true);
    }
}
