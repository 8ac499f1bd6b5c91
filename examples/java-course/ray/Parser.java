package ray;

import java.io.File;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.HashMap;
import java.util.Map;

import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;

import org.w3c.dom.Element;
import org.w3c.dom.Node;

/**
 * Turns a scene file into objects: &lt;foo&gt; inside &lt;bar&gt; becomes a call of setFoo or addFoo
 * on the object that was made for bar. The type of that method's parameter tells what to make of foo,
 * unless foo has a type attribute. Idea and first version: André Müller-Núñez.
 */
class Parser {

    private static final String[] PACKAGES = {"", "ray.surface.", "ray.shader.", "ray."};

    private final File file;
    private final Map<String, Object> named = new HashMap<>();

    Parser(File file) {
        this.file = file;
    }

    Object parse() throws Exception {
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
        DocumentBuilder builder = factory.newDocumentBuilder();
        builder.setErrorHandler(null);
        Element root = builder.parse(file).getDocumentElement();
        if (!root.getTagName().equalsIgnoreCase("scene")) {
            throw new IllegalArgumentException("a <scene> is expected");
        }
        return make(root, Scene.class);
    }

    private Object make(Element e, Class<?> wanted) throws Exception {
        Object result;
        if (e.hasAttribute("ref")) {
            result = named.get(e.getAttribute("ref"));
            if (result == null) {
                throw new IllegalArgumentException("nothing has the name " + e.getAttribute("ref"));
            }
        } else if (wanted == double.class) {
            result = Double.valueOf(e.getTextContent().trim());
        } else if (wanted == int.class) {
            result = Integer.valueOf(e.getTextContent().trim());
        } else if (wanted == File.class) {
            result = new File(file.getAbsoluteFile().getParentFile(), e.getTextContent().trim());
        } else {
            Class<?> type = e.hasAttribute("type") ? find(e.getAttribute("type")) : wanted;
            if (!wanted.isAssignableFrom(type)) {
                throw new IllegalArgumentException(type.getSimpleName() + " is no " + e.getTagName());
            }
            result = makeObject(e, type);
        }
        if (e.hasAttribute("name")) {
            named.put(e.getAttribute("name"), result);
        }
        return result;
    }

    private Object makeObject(Element e, Class<?> type) throws Exception {
        for (Method method : type.getMethods()) {
            if (method.getName().equals("parse")) {
                return call(method, null, e.getTextContent());
            }
        }
        Object result = type.getConstructor().newInstance();
        for (Node n = e.getFirstChild(); n != null; n = n.getNextSibling()) {
            if (n instanceof Element) {
                Element child = (Element) n;
                Method method = setter(type, child.getTagName());
                call(method, result, make(child, method.getParameterTypes()[0]));
            }
        }
        for (Method method : type.getMethods()) {
            if (method.getName().equals("finish")) {
                call(method, result);
            }
        }
        return result;
    }

    private static Method setter(Class<?> type, String tag) {
        for (Method method : type.getMethods()) {
            String name = method.getName();
            if (method.getParameterCount() == 1
                    && (name.equalsIgnoreCase("set" + tag) || name.equalsIgnoreCase("add" + tag))) {
                return method;
            }
        }
        throw new IllegalArgumentException("<" + tag + "> is unknown inside " + type.getSimpleName());
    }

    private static Class<?> find(String type) {
        for (String prefix : PACKAGES) {
            try {
                return Class.forName(prefix + type);
            } catch (ClassNotFoundException e) {
                // perhaps it is in the next package
            }
        }
        throw new IllegalArgumentException("unknown type " + type);
    }

    /** Calls a method and lets its own exception through. */
    private static Object call(Method method, Object on, Object... arguments) throws Exception {
        try {
            return method.invoke(on, arguments);
        } catch (InvocationTargetException e) {
            throw e.getCause() instanceof Exception ? (Exception) e.getCause() : e;
        }
    }
}
