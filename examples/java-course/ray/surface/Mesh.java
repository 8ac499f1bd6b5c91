package ray.surface;

import java.io.BufferedReader;
import java.io.File;
import java.io.FileReader;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.StringTokenizer;

import ray.Hit;
import ray.math.Ray;
import ray.math.Vec;

/** Triangles from a .msh file, under a tree of boxes. Reading and tree: François Béranger. */
public class Mesh extends Surface {

    Vec[] vertices = {};
    int[] triangles = {};
    private Vec[] normals;
    private MeshNode root;
    private BufferedReader in;
    private final ArrayDeque<String> words = new ArrayDeque<>();

    public void setData(File file) throws IOException {
        try (BufferedReader reader = new BufferedReader(new FileReader(file))) {
            in = reader;
            int vertexCount = (int) number();
            int triangleCount = (int) number();
            for (String word = next(); word != null; word = next()) {
                if (word.equals("vertices")) {
                    vertices = vectors(vertexCount);
                } else if (word.equals("triangles")) {
                    triangles = new int[3 * triangleCount];
                    for (int i = 0; i < triangles.length; i++) {
                        triangles[i] = (int) number();
                        if (triangles[i] < 0 || triangles[i] >= vertexCount) {
                            throw new IOException(file + ": there is no vertex " + triangles[i]);
                        }
                    }
                } else if (word.equals("normals")) {
                    normals = vectors(vertexCount);
                } else if (word.equals("texcoords")) {
                    for (int i = 0; i < 2 * vertexCount; i++) {
                        number();
                    }
                } else {
                    throw new IOException(file + ": " + word + " is not expected");
                }
            }
        } catch (NumberFormatException e) {
            throw new IOException(file + ": a number is missing or wrong", e);
        }
        if (triangles.length == 0 || vertices.length == 0) {
            throw new IOException(file + ": there are no triangles");
        }
        root = MeshNode.build(this);
    }

    /** The next word of the file, or null at its end. */
    private String next() throws IOException {
        while (words.isEmpty()) {
            String line = in.readLine();
            if (line == null) {
                return null;
            }
            StringTokenizer tokens = new StringTokenizer(line);
            while (tokens.hasMoreTokens()) {
                words.add(tokens.nextToken());
            }
        }
        return words.remove();
    }

    private double number() throws IOException {
        String word = next();
        if (word == null) {
            throw new NumberFormatException();
        }
        return Float.parseFloat(word);
    }

    private Vec[] vectors(int count) throws IOException {
        Vec[] list = new Vec[count];
        for (int i = 0; i < count; i++) {
            double x = number();
            double y = number();
            list[i] = new Vec(x, y, number());
        }
        return list;
    }

    /** Called by the parser when all has been read. */
    public void finish() {
        if (root == null) {
            throw new IllegalArgumentException("a mesh has no data");
        }
    }

    @Override
    public boolean intersect(Ray ray, Hit hit) {
        return root.intersect(this, ray, hit);
    }

    /** One triangle, with beta and gamma the weights of its second and third corner. */
    boolean intersectTriangle(int index, Ray ray, Hit hit) {
        int i0 = triangles[3 * index];
        int i1 = triangles[3 * index + 1];
        int i2 = triangles[3 * index + 2];
        Vec e1 = vertices[i1].sub(vertices[i0]);
        Vec e2 = vertices[i2].sub(vertices[i0]);
        Vec o = ray.origin.sub(vertices[i0]);
        Vec p = ray.direction.cross(e2);
        Vec q = o.cross(e1);
        double determinant = e1.dot(p);
        if (determinant == 0) {
            return false;
        }
        double beta = o.dot(p) / determinant;
        double gamma = ray.direction.dot(q) / determinant;
        if (beta < 0 || gamma < 0 || beta + gamma > 1) {
            return false;
        }
        Vec n = normals == null ? e1.cross(e2)
                : normals[i0].scale(1 - beta - gamma).add(normals[i1].scale(beta))
                        .add(normals[i2].scale(gamma));
        return hit.offer(ray, e2.dot(q) / determinant, n);
    }
}
