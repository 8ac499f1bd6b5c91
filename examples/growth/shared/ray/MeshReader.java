package ray;

import java.io.BufferedReader;
import java.io.File;
import java.io.FileReader;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.StringTokenizer;

/** Reads triangles from a .msh file. */
class MeshReader {

    private final BufferedReader in;
    private StringTokenizer words = new StringTokenizer("");

    private MeshReader(BufferedReader in) {
        this.in = in;
    }

    static List<Triangle> read(File file) throws IOException {
        try (BufferedReader in = new BufferedReader(new FileReader(file))) {
            return new MeshReader(in).triangles();
        }
    }

    private List<Triangle> triangles() throws IOException {
        int vertexCount = Integer.parseInt(next());
        int triangleCount = Integer.parseInt(next());
        Vec[] vertices = {};
        Vec[] normals = null;
        int[] corners = {};
        for (String word = next(); word != null; word = next()) {
            if (word.equals("vertices")) {
                vertices = vectors(vertexCount);
            } else if (word.equals("normals")) {
                normals = vectors(vertexCount);
            } else if (word.equals("triangles")) {
                corners = new int[3 * triangleCount];
                for (int i = 0; i < corners.length; i++) {
                    corners[i] = Integer.parseInt(next());
                }
            } else if (word.equals("texcoords")) {
                for (int i = 0; i < 2 * vertexCount; i++) {
                    next();
                }
            } else {
                throw new IOException(word + " is not expected in a mesh");
            }
        }
        List<Triangle> list = new ArrayList<>();
        for (int i = 0; i < corners.length; i += 3) {
            int a = corners[i];
            int b = corners[i + 1];
            int c = corners[i + 2];
            Vec[] own = normals == null ? null : new Vec[] {normals[a], normals[b], normals[c]};
            list.add(new Triangle(vertices[a], vertices[b], vertices[c], own));
        }
        return list;
    }

    private String next() throws IOException {
        while (!words.hasMoreTokens()) {
            String line = in.readLine();
            if (line == null) {
                return null;
            }
            words = new StringTokenizer(line);
        }
        return words.nextToken();
    }

    private Vec[] vectors(int count) throws IOException {
        Vec[] list = new Vec[count];
        for (int i = 0; i < count; i++) {
            double x = Float.parseFloat(next());
            double y = Float.parseFloat(next());
            list[i] = new Vec(x, y, Float.parseFloat(next()));
        }
        return list;
    }
}
