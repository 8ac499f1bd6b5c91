package ray;

import java.io.File;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.StringTokenizer;

import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;

import org.w3c.dom.Element;
import org.w3c.dom.Node;

import ray.math.Color;
import ray.math.Vector3;

/**
 * Reads a scene file: an element &lt;foo&gt; inside &lt;bar&gt; becomes a call of setFoo or addFoo on the object made
 * for bar. What foo is made into follows from the parameter of that method and from foo's type attribute. When
 * all has been set, the object's method check is called if it has one.
 */
class Parser {

    private static final String[] PACKAGES = {"ray.surface.", "ray.shader.", "ray."};

    private final File file;
    private final Map<String, Object> named = new HashMap<>();

    // To find a class or a method by its name takes long, and a scene may have thousands of spheres.
    private final Map<String, Class<?>> types = new HashMap<>();
    private final Map<Class<?>, Map<String, Method>> methods = new HashMap<>();

    Parser(File file) {
        this.file = file;
    }

    Scene parse() throws Exception {
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
        DocumentBuilder builder = factory.newDocumentBuilder();
        builder.setErrorHandler(null);
        Element root = builder.parse(file).getDocumentElement();
        if (!root.getTagName().equalsIgnoreCase("scene")) {
            throw new IllegalArgumentException("expected <scene>, not <" + root.getTagName() + ">");
        }
        return (Scene) object(root, Scene.class);
    }

    /** What an element stands for, as a value that can be given to a parameter of a type. */
    private Object value(Element e, Class<?> wanted) throws Exception {
        Object result;
        if (e.hasAttribute("ref")) {
            result = named.get(e.getAttribute("ref"));
            if (!boxed(wanted).isInstance(result)) {
                throw new IllegalArgumentException("nothing that fits <" + e.getTagName() + "> has the name "
                        + e.getAttribute("ref") + " before it is referred to");
            }
        } else {
            result = simple(e, wanted);
            if (result == null) {
                result = object(e, wanted);
            }
        }
        if (e.hasAttribute("name")) {
            named.put(e.getAttribute("name"), result);
        }
        return result;
    }

    /** The value of an element that holds only text, or null if the type is one with elements of its own. */
    private Object simple(Element e, Class<?> wanted) {
        if (wanted == File.class) {
            return new File(file.getAbsoluteFile().getParentFile(), e.getTextContent().trim());
        } else if (wanted == double.class) {
            return numbers(e, 1)[0];
        } else if (wanted == int.class) {
            return wholeNumbers(e, 1)[0];
        } else if (wanted == int[].class) {
            return wholeNumbers(e, 2);
        } else if (wanted == Vector3.class) {
            double[] n = numbers(e, 3);
            return new Vector3(n[0], n[1], n[2]);
        } else if (wanted == Color.class) {
            double[] n = numbers(e, 3);
            return new Color(n[0], n[1], n[2]);
        }
        return null;
    }

    private Object object(Element e, Class<?> wanted) throws Exception {
        Class<?> type = e.hasAttribute("type") ? types.computeIfAbsent(e.getAttribute("type"), Parser::find) : wanted;
        if (!wanted.isAssignableFrom(type)) {
            throw new IllegalArgumentException("a " + type.getSimpleName() + " is no " + e.getTagName());
        }
        if (Modifier.isAbstract(type.getModifiers())) {
            throw new IllegalArgumentException("<" + e.getTagName() + "> needs a type");
        }
        Object result = type.getConstructor().newInstance();
        Set<Method> called = new HashSet<>();
        for (Node n = e.getFirstChild(); n != null; n = n.getNextSibling()) {
            if (n instanceof Element) {
                Element child = (Element) n;
                Method method = setter(type, child.getTagName());
                if (!called.add(method) && method.getName().startsWith("set")) {
                    System.err.println(file + ": warning: <" + child.getTagName() + "> twice: the last one counts");
                }
                call(method, child.getTagName(), result, value(child, method.getParameterTypes()[0]));
            }
        }
        Method check = methods(type).get("check");
        if (check != null) {
            call(check, e.getTagName(), result);
        }
        return result;
    }

    private Method setter(Class<?> type, String tag) {
        Map<String, Method> known = methods(type);
        String name = tag.toLowerCase(Locale.ROOT);
        Method method = known.getOrDefault("set" + name, known.get("add" + name));
        if (method == null) {
            throw new IllegalArgumentException("<" + tag + "> is unknown in a " + type.getSimpleName());
        }
        return method;
    }

    /** The methods of a class that are of interest here, by their names in small letters. */
    private Map<String, Method> methods(Class<?> type) {
        return methods.computeIfAbsent(type, key -> {
            Map<String, Method> known = new HashMap<>();
            for (Method method : key.getMethods()) {
                String name = method.getName();
                boolean sets = name.startsWith("set") || name.startsWith("add");
                if (sets && method.getParameterCount() == 1 || name.equals("check")) {
                    known.put(name.toLowerCase(Locale.ROOT), method);
                }
            }
            return known;
        });
    }

    /** A type may be written with a package before it; where the class really is, is known here. */
    private static Class<?> find(String type) {
        String name = type.substring(type.lastIndexOf('.') + 1);
        for (String prefix : PACKAGES) {
            try {
                return Class.forName(prefix + name);
            } catch (ClassNotFoundException | NoClassDefFoundError e) {
                // perhaps it is in the next package
            }
        }
        throw new IllegalArgumentException("the type " + type + " is unknown");
    }

    private static double[] numbers(Element e, int count) {
        StringTokenizer words = new StringTokenizer(e.getTextContent());
        if (words.countTokens() != count) {
            throw new IllegalArgumentException("<" + e.getTagName() + "> needs " + count + " numbers");
        }
        double[] result = new double[count];
        for (int i = 0; i < count; i++) {
            String word = words.nextToken();
            try {
                result[i] = Double.parseDouble(word);
            } catch (NumberFormatException notANumber) {
                result[i] = Double.NaN;
            }
            if (Double.isNaN(result[i]) || Double.isInfinite(result[i])) {
                throw new IllegalArgumentException("<" + e.getTagName() + ">: " + word + " is not a number");
            }
        }
        return result;
    }

    private static int[] wholeNumbers(Element e, int count) {
        double[] numbers = numbers(e, count);
        int[] result = new int[count];
        for (int i = 0; i < count; i++) {
            result[i] = (int) numbers[i];
            if (result[i] != numbers[i]) {
                throw new IllegalArgumentException("<" + e.getTagName() + ">: " + numbers[i] + " is not whole");
            }
        }
        return result;
    }

    private static Class<?> boxed(Class<?> type) {
        return type == double.class ? Double.class : type == int.class ? Integer.class : type;
    }

    /** Calls a method; what it throws gets the tag in front. */
    private static void call(Method method, String tag, Object on, Object... arguments) throws Exception {
        try {
            method.invoke(on, arguments);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof IllegalArgumentException) {
                throw new IllegalArgumentException("<" + tag + ">: " + e.getCause().getMessage());
            }
            throw e.getCause() instanceof Exception ? (Exception) e.getCause() : e;
        }
    }
}
