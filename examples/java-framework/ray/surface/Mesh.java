package ray.surface;

import java.io.BufferedReader;
import java.io.File;
import java.io.FileReader;
import java.io.IOException;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.stream.Stream;

import ray.IntersectionRecord;
import ray.Ray;
import ray.math.Bounds;
import ray.math.Matrix4;
import ray.math.Point3;
import ray.math.Vector3;

/** Triangles with common vertices, from a .msh file, whose numbers are kept in single precision. */
public class Mesh extends Surface {

    private float[] vertices = {};
    private float[] normals;
    private int[] triangles = {};
    private Triangle[] parts = {};
    /** The box of each vertex in the world. */
    private Point3[] vertexMin = {};
    private Point3[] vertexMax = {};

    public void setData(File file) throws IOException {
        System.out.println("Loading " + file.getName());
        try (BufferedReader reader = new BufferedReader(new FileReader(file))) {
            Iterator<String> words = reader.lines().flatMap(line -> Stream.of(line.trim().split("\\s+")))
                    .filter(word -> !word.isEmpty()).iterator();
            int vertexCount = Integer.parseInt(words.next());
            int triangleCount = Integer.parseInt(words.next());
            while (words.hasNext()) {
                String section = words.next();
                if (section.equals("vertices")) {
                    vertices = floats(words, 3 * vertexCount);
                } else if (section.equals("normals")) {
                    normals = floats(words, 3 * vertexCount);
                } else if (section.equals("texcoords")) {
                    floats(words, 2 * vertexCount);
                } else if (section.equals("triangles")) {
                    triangles = new int[3 * triangleCount];
                    Arrays.setAll(triangles, i -> Integer.parseInt(words.next()));
                } else {
                    throw new IOException(file.getName() + ": " + section + " is not expected");
                }
            }
        } catch (RuntimeException e) {
            throw new IOException(file.getName() + ": a number is missing or wrong", e);
        }
        for (int index : triangles) {
            if (index < 0 || index >= vertices.length / 3) {
                throw new IOException(file.getName() + ": there is no vertex " + index);
            }
        }
        parts = new Triangle[triangles.length / 3];
        Arrays.setAll(parts, i -> new Triangle(this, Arrays.copyOfRange(triangles, 3 * i, 3 * i + 3)));
    }

    private static float[] floats(Iterator<String> words, int count) {
        float[] list = new float[count];
        for (int i = 0; i < count; i++) {
            list[i] = Float.parseFloat(words.next());
        }
        return list;
    }

    public Point3 getVertex(int i) {
        return new Point3(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]);
    }

    public boolean existsNormals() {
        return normals != null;
    }

    public Vector3 getNormal(int i) {
        return new Vector3(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
    }

    Point3 vertexMin(int i) {
        return vertexMin[i];
    }

    Point3 vertexMax(int i) {
        return vertexMax[i];
    }

    @Override
    public void setTransformation(Matrix4 toWorld, Matrix4 inverse, Matrix4 inverseTransposed) {
        super.setTransformation(toWorld, inverse, inverseTransposed);
        for (Triangle triangle : parts) {
            triangle.setTransformation(toWorld, inverse, inverseTransposed);
        }
    }

    @Override
    public void computeBoundingBox() {
        int count = vertices.length / 3;
        vertexMin = new Point3[count];
        vertexMax = new Point3[count];
        for (int i = 0; i < count; i++) {
            Bounds bounds = new Bounds();
            bounds.add(tMat, vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]);
            vertexMin[i] = bounds.min();
            vertexMax[i] = bounds.max();
        }
    }

    @Override
    public boolean intersect(IntersectionRecord record, Ray ray) {
        throw new IllegalStateException("a mesh's triangles are intersected, not the mesh");
    }

    @Override
    public void appendRenderableSurfaces(List<Surface> list) {
        for (Triangle triangle : parts) {
            triangle.setShader(shader);
            list.add(triangle);
        }
    }
}
