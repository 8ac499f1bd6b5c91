package ray.surface;

import java.util.ArrayList;
import java.util.List;

import ray.math.Matrix4;
import ray.math.Vector3;
import ray.shader.Shader;

/** Surfaces under a common transformation. */
public class Group extends Surface {

    private final List<Surface> members = new ArrayList<>();
    private Matrix4 transform = Matrix4.IDENTITY;

    public void addSurface(Surface member) {
        members.add(member);
    }

    public void addTranslate(Vector3 by) {
        append(Matrix4.translate(by));
    }

    /** About x first, then about y, then about z. */
    public void addRotate(Vector3 degrees) {
        append(Matrix4.rotateZ(degrees.z).times(Matrix4.rotateY(degrees.y)).times(Matrix4.rotateX(degrees.x)));
    }

    public void addScale(Vector3 by) {
        append(Matrix4.scale(by));
    }

    /** The first transformation in the file is the outermost. */
    private void append(Matrix4 next) {
        transform = transform.times(next);
    }

    @Override
    public void place(Matrix4 toWorld, Shader inherited, List<Instance> instances) {
        for (Surface member : members) {
            member.place(toWorld.times(transform), shader != null ? shader : inherited, instances);
        }
    }
}
