package ray;

/** Matt, with a highlight if its specular colour is not black. */
public class Shader {

    public Vec diffuse = new Vec(1, 1, 1);
    public Vec specular = Vec.ZERO;
    public double exponent = 1;

    /** What it makes of white light from l, seen from v. */
    public Vec factor(Vec n, Vec l, Vec v) {
        Vec h = l.add(v).unit();
        return diffuse.scale(Math.max(0, n.dot(l)))
                .add(specular.scale(Math.pow(Math.max(0, n.dot(h)), exponent)));
    }
}
