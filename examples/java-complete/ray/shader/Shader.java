package ray.shader;

import ray.Scene;
import ray.math.Color;

/** How a surface looks: the light that leaves a point of it towards whoever looks at it. */
public interface Shader {

    Color shade(Scene scene, ShadingPoint at);
}
