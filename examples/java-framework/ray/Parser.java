package ray;

import java.io.File;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.HashMap;
import java.util.Map;

import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;

import org.w3c.dom.Element;
import org.w3c.dom.Node;

import ray.surface.Surface;

/**
 * Makes objects of a scene file: a &lt;foo&gt; within the element of an object is handed to that object's setFoo or
 * addFoo, whose parameter says what to make of it, unless a type attribute names a class below it.
 */
public class Parser {

    private static final String[] PACKAGES = {"", "ray.surface.", "ray.shader.", "ray."};

    private final Map<String, Object> named = new HashMap<>();
    private final Map<String, Element> namedElements = new HashMap<>();
    private File folder;

    public Object parse(String file, Class<?> type) {
        try {
            folder = new File(file).getAbsoluteFile().getParentFile();
            DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
            factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
            DocumentBuilder builder = factory.newDocumentBuilder();
            builder.setErrorHandler(null);
            return make(builder.parse(new File(file)).getDocumentElement(), type);
        } catch (Exception e) {
            Throwable cause = e instanceof InvocationTargetException ? e.getCause() : e;
            throw new IllegalArgumentException(file + ": " + cause.getMessage(), cause);
        }
    }

    private Object make(Element element, Class<?> wanted) throws Exception {
        String text = element.getTextContent().trim();
        Object made;
        String ref = element.getAttribute("ref");
        if (named.get(ref) instanceof Surface) {
            made = make(namedElements.get(ref), wanted);  // a surface has one place; in a second there is a second one
        } else if (!ref.isEmpty()) {
            made = named.get(ref);
        } else if (wanted == double.class || wanted == int.class) {
            made = number(text, wanted);
        } else if (wanted == File.class) {
            made = new File(folder, text);
        } else {
            String type = element.getAttribute("type");
            made = makeObject(element, type.isEmpty() ? wanted : find(type), text);
        }
        if (!wanted.isPrimitive() && !wanted.isInstance(made)) {
            throw new IllegalArgumentException("<" + element.getTagName() + "> is no " + wanted.getSimpleName());
        }
        if (element.hasAttribute("name")) {
            named.put(element.getAttribute("name"), made);
            namedElements.put(element.getAttribute("name"), element);
        }
        return made;
    }

    private Object makeObject(Element element, Class<?> type, String text) throws Exception {
        boolean hasChildren = element.getElementsByTagName("*").getLength() > 0;
        if (!hasChildren && !text.isEmpty()) {
            return makeOfNumbers(type, text.split("\\s+"));
        }
        Object object = type.getConstructor().newInstance();
        for (Node node = element.getFirstChild(); node != null; node = node.getNextSibling()) {
            if (node instanceof Element) {
                Method setter = setter(type, ((Element) node).getTagName());
                setter.invoke(object, make((Element) node, setter.getParameterTypes()[0]));
            }
        }
        return object;
    }

    /** "1 2 3" goes to the constructor of three numbers. */
    private static Object makeOfNumbers(Class<?> type, String[] words) throws Exception {
        for (Constructor<?> constructor : type.getConstructors()) {
            Class<?>[] types = constructor.getParameterTypes();
            if (types.length != words.length || !types[0].isPrimitive()) {
                continue;
            }
            Object[] numbers = new Object[words.length];
            for (int i = 0; i < words.length; i++) {
                numbers[i] = number(words[i], types[i]);
            }
            return constructor.newInstance(numbers);
        }
        throw new IllegalArgumentException("a " + type.getSimpleName() + " is not made of " + words.length + " words");
    }

    private static Object number(String word, Class<?> type) {
        if (type == int.class) {
            return Integer.valueOf(word);
        }
        double value = Double.parseDouble(word);
        if (Double.isNaN(value) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(word + " is no finite number");
        }
        return value;
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
                continue;  // perhaps it is in the next package
            }
        }
        throw new IllegalArgumentException("there is no class for the type " + type);
    }
}
