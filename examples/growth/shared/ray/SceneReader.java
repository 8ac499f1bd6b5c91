package ray;

import java.io.File;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;

import javax.xml.parsers.DocumentBuilderFactory;

import org.w3c.dom.Element;
import org.w3c.dom.Node;

/** Reads a scene file. */
class SceneReader {

    private final Scene scene = new Scene();
    private final File folder;
    private final Map<String, Shader> named = new HashMap<>();

    private SceneReader(File file) {
        folder = file.getAbsoluteFile().getParentFile();
    }

    static Scene read(File file) throws Exception {
        Element root = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file).getDocumentElement();
        SceneReader reader = new SceneReader(file);
        for (Node n = root.getFirstChild(); n != null; n = n.getNextSibling()) {
            if (n instanceof Element) {
                reader.add((Element) n);
            }
        }
        if (reader.scene.camera == null || reader.scene.width < 1 || reader.scene.height < 1) {
            throw new IOException("the scene has no camera or no <image>");
        }
        reader.scene.finish();
        return reader.scene;
    }

    private void add(Element e) throws IOException {
        switch (e.getTagName()) {
            case "camera":
                Vec direction = vec(e, "viewDir", new Vec(0, 0, -1));
                scene.camera = new Camera(vec(e, "viewPoint", Vec.ZERO), direction, vec(e, "projNormal", direction),
                        vec(e, "viewUp", new Vec(0, 1, 0)), number(e, "projDistance", 1), number(e, "viewWidth", 1),
                        number(e, "viewHeight", 1));
                break;
            case "image":
                String[] words = e.getTextContent().trim().split("\\s+");
                scene.width = Integer.parseInt(words[0]);
                scene.height = Integer.parseInt(words[1]);
                break;
            case "light":
                Vec white = new Vec(1, 1, 1);
                scene.lights.add(new Light(vec(e, "position", Vec.ZERO), vec(e, "intensity", vec(e, "color", white))));
                break;
            case "shader":
                shader(e);
                break;
            case "surface":
                surface(e);
                break;
            default:
        }
    }

    private Shader shader(Element e) {
        if (e == null) {
            return new Shader();
        }
        if (e.hasAttribute("ref")) {
            return named.get(e.getAttribute("ref"));
        }
        Shader shader = new Shader();
        shader.diffuse = vec(e, "diffuseColor", new Vec(1, 1, 1));
        if (e.getAttribute("type").endsWith("Phong")) {
            shader.specular = vec(e, "specularColor", new Vec(1, 1, 1));
            shader.exponent = number(e, "exponent", 1);
        }
        named.put(e.getAttribute("name"), shader);
        return shader;
    }

    private void surface(Element e) throws IOException {
        Shader shader = shader(child(e, "shader"));
        String type = e.getAttribute("type");
        if (type.endsWith("Sphere")) {
            scene.add(new Sphere(vec(e, "center", Vec.ZERO), number(e, "radius", 1)), shader);
        } else if (type.endsWith("Mesh")) {
            File file = new File(folder, child(e, "data").getTextContent().trim());
            for (Triangle triangle : MeshReader.read(file)) {
                scene.add(triangle, shader);
            }
        } else {
            throw new IOException("unknown surface " + type);
        }
    }

    private static Element child(Element e, String tag) {
        for (Node n = e.getFirstChild(); n != null; n = n.getNextSibling()) {
            if (n instanceof Element && n.getNodeName().equals(tag)) {
                return (Element) n;
            }
        }
        return null;
    }

    private static double number(Element e, String tag, double otherwise) {
        Element c = child(e, tag);
        return c == null ? otherwise : Double.parseDouble(c.getTextContent().trim());
    }

    private static Vec vec(Element e, String tag, Vec otherwise) {
        Element c = child(e, tag);
        if (c == null) {
            return otherwise;
        }
        String[] words = c.getTextContent().trim().split("\\s+");
        return new Vec(Double.parseDouble(words[0]), Double.parseDouble(words[1]), Double.parseDouble(words[2]));
    }
}
