package ray;

public class Sphere extends Surface {

    private final Vec center;
    private final double radius;

    public Sphere(Vec center, double radius) {
        this.center = center;
        this.radius = radius;
    }

    @Override
    public void intersect(Ray ray, Hit hit) {
        Vec o = ray.origin.sub(center);
        Vec d = ray.direction;
        double a = d.dot(d);
        double b = o.dot(d);
        double discriminant = b * b - a * (o.dot(o) - radius * radius);
        if (discriminant < 0) {
            return;
        }
        double root = Math.sqrt(discriminant);
        double t0 = (-b - root) / a;
        double t1 = (-b + root) / a;
        if (!hit.offer(t0, this, o.add(d.scale(t0)))) {
            hit.offer(t1, this, o.add(d.scale(t1)));
        }
    }

    @Override
    public Box box() {
        Vec r = new Vec(radius, radius, radius);
        return new Box(center.sub(r), center.add(r));
    }

    @Override
    public Vec centre() {
        return center;
    }
}
