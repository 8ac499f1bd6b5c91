package ray;

import java.util.ArrayList;
import java.util.List;

/** What is drawn. */
public class Scene {

    public Camera camera;
    public int width;
    public int height;
    public final List<Light> lights = new ArrayList<>();
    public final List<Surface> surfaces = new ArrayList<>();
    private Search search;

    public void add(Surface surface, Shader shader) {
        surface.place = surfaces.size();
        surface.shader = shader;
        surfaces.add(surface);
    }

    /** To be called when all has been added. */
    public void finish() {
        search = new Search(surfaces);
    }

    /** The colour that comes back along a ray. */
    public Vec trace(Ray ray) {
        Hit hit = new Hit(Double.POSITIVE_INFINITY);
        search.closest(ray, hit);
        if (hit.surface == null) {
            return Vec.ZERO;
        }
        Vec point = ray.at(hit.t);
        Vec n = hit.normal.unit();
        Vec v = ray.direction.scale(-1).unit();
        Vec color = Vec.ZERO;
        for (Light light : lights) {
            if (sees(point, light)) {
                Vec l = light.position.sub(point).unit();
                color = color.add(light.intensity.times(hit.surface.shader.factor(n, l, v)));
            }
        }
        return color;
    }

    private boolean sees(Vec point, Light light) {
        Hit blocker = new Hit(1);
        search.closest(new Ray(point, light.position.sub(point)), blocker);
        return blocker.surface == null;
    }
}
