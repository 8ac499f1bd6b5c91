package ray.shader;

public class Glass extends Shader {

    protected double refractiveIndex;

    public void setRefractiveIndex(double refractiveIndex) {
        this.refractiveIndex = refractiveIndex;
    }
}
