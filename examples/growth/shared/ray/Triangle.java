package ray;

public class Triangle extends Surface {

    private final Vec a;
    private final Vec b;
    private final Vec c;
    /** Of the corners, or null. */
    private final Vec[] normals;

    public Triangle(Vec a, Vec b, Vec c, Vec[] normals) {
        this.a = a;
        this.b = b;
        this.c = c;
        this.normals = normals;
    }

    @Override
    public void intersect(Ray ray, Hit hit) {
        Vec e1 = b.sub(a);
        Vec e2 = c.sub(a);
        Vec o = ray.origin.sub(a);
        Vec p = ray.direction.cross(e2);
        Vec q = o.cross(e1);
        double determinant = e1.dot(p);
        if (determinant == 0) {
            return;
        }
        double beta = o.dot(p) / determinant;
        double gamma = ray.direction.dot(q) / determinant;
        if (beta < 0 || gamma < 0 || beta + gamma > 1) {
            return;
        }
        Vec n = normals == null ? e1.cross(e2)
                : normals[0].scale(1 - beta - gamma).add(normals[1].scale(beta)).add(normals[2].scale(gamma));
        hit.offer(e2.dot(q) / determinant, this, n);
    }

    @Override
    public Box box() {
        return new Box(a.min(b).min(c), a.max(b).max(c));
    }

    @Override
    public Vec centre() {
        return a.add(b).add(c).scale(1 / 3.0);
    }
}
