package ray.surface;

import java.io.File;
import java.io.IOException;

/** What a .msh file says: vertices, triangles and, perhaps, normals. Texture coordinates are passed over. */
final class MeshFile {

    /** x, y, z of each vertex, rounded to single precision. */
    double[] vertices;

    /** Three indices of vertices for each triangle. */
    int[] corners;

    /** x, y, z of the normal at each vertex, or null. */
    double[] normals;

    private final WordReader in;

    MeshFile(File file) throws IOException {
        in = new WordReader(file);
        int vertexCount = in.nextCount();
        int triangleCount = in.nextCount();
        for (String keyword = in.next(); keyword != null; keyword = in.next()) {
            switch (keyword) {
                case "vertices":
                    vertices = numbers(3, vertexCount);
                    break;
                case "triangles":
                    corners = indices(triangleCount, vertexCount);
                    break;
                case "texcoords":
                    numbers(2, vertexCount);
                    break;
                case "normals":
                    normals = numbers(3, vertexCount);
                    break;
                default:
                    throw in.error("'" + keyword + "' is no part of a mesh");
            }
        }
        if (vertices == null || corners == null) {
            throw in.error("the vertices or the triangles are missing");
        }
    }

    private double[] numbers(int each, int count) throws IOException {
        double[] list = new double[in.checkedLength(each, count)];
        for (int i = 0; i < list.length; i++) {
            list[i] = in.nextFloat();
        }
        return list;
    }

    private int[] indices(int triangleCount, int vertexCount) throws IOException {
        int[] list = new int[in.checkedLength(3, triangleCount)];
        for (int i = 0; i < list.length; i++) {
            list[i] = in.nextCount();
            if (list[i] >= vertexCount) {
                throw in.error("there is no vertex " + list[i]);
            }
        }
        return list;
    }
}
