package ray.shader;

public class Glazed extends Glass {

    protected Shader substrate;

    public void setSubstrate(Shader substrate) {
        this.substrate = substrate;
    }
}
