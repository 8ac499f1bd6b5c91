// SPDX-License-Identifier: Apache-2.0

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.lang.reflect.Array;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Answers the probe protocol of Plumbline (docs/probe-protocol.md) for a ray tracer built on the course's Java
 * framework, whatever the year. It is compiled against nothing: every class and member is looked up by its name at run
 * time, and what is not there is answered with "unsupported" and the name of the missing member. See README.md beside
 * this file.
 */
public final class PlumbProbe {
  private PlumbProbe() {}

  public static void main(String[] arguments) throws Exception {
    InputStream questions = System.in;
    Writer answers =
        new BufferedWriter(new OutputStreamWriter(new FileOutputStream(FileDescriptor.out), StandardCharsets.UTF_8));
    // From here on standard output belongs to the answers alone; no class of the subject has been loaded yet.
    System.setOut(System.err);
    System.setIn(new ByteArrayInputStream(new byte[0]));
    System.setProperty("java.awt.headless", "true");

    Session session = new Session();
    say(answers, session.greeting());
    BufferedReader lines = new BufferedReader(new InputStreamReader(questions, StandardCharsets.UTF_8));
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      Map<?, ?> question = (Map<?, ?>) new JsonReader(line).read();
      if ("quit".equals(question.get("ask"))) break;
      say(answers, answer(session, question));
    }
    System.exit(0); // the subject may have started threads
  }

  private static Map<String, Object> answer(Session session, Map<?, ?> question) {
    Map<String, Object> answer = new LinkedHashMap<>();
    answer.put("plumb", 1);
    answer.put("id", question.get("id"));
    try {
      session.answer(String.valueOf(question.get("ask")), question, answer);
    } catch (Unsupported e) {
      answer.put("unsupported", e.getMessage());
    } catch (Throwable e) { // an error of the subject's, a stack overflow too, is an answer
      Throwable cause = root(e);
      if (!(cause instanceof Refused)) cause.printStackTrace();
      answer.put("error", sentence(cause));
    }
    return answer;
  }

  private static void say(Writer answers, Map<String, Object> answer) throws Exception {
    StringBuilder text = new StringBuilder();
    JsonWriter.write(text, answer);
    System.err.flush();
    answers.append(text.append('\n')).flush();
  }

  private static Throwable root(Throwable e) {
    while (e instanceof InvocationTargetException || e instanceof ExceptionInInitializerError) {
      if (e.getCause() == null) break;
      e = e.getCause();
    }
    return e;
  }

  private static String sentence(Throwable e) {
    if (e instanceof Refused) return e.getMessage();
    StringBuilder text = new StringBuilder(e.getClass().getSimpleName());
    if (e.getMessage() != null) text.append(": ").append(e.getMessage());
    if (e.getStackTrace().length > 0) text.append(", at ").append(e.getStackTrace()[0]);
    return text.toString();
  }

  /** The subject lacks something; the sentence names it. */
  static final class Unsupported extends RuntimeException {
    private static final long serialVersionUID = 1L;

    Unsupported(String sentence) {
      super(sentence);
    }
  }

  /** The subject has what is needed, but it does not work; the sentence says what. */
  static final class Refused extends RuntimeException {
    private static final long serialVersionUID = 1L;

    Refused(String sentence) {
      super(sentence);
    }
  }

  // ------------------------------------------------------------------------------------------------- the questions

  /** The questions of the protocol, put to the scene that was loaded last. */
  static final class Session {
    private final Framework framework = Framework.find();
    private LoadedScene scene;

    Map<String, Object> greeting() {
      Map<String, Object> greeting = new LinkedHashMap<>();
      greeting.put("plumb", 1);
      greeting.put("name", framework == null ? "java" : "java-" + framework.root);
      if (framework != null) framework.describe(greeting);
      // What cannot be seen from outside may be said on the command line.
      for (String key : new String[] {"name", "edges", "culling", "range", "inside"})
        if (System.getProperty("plumb." + key) != null) greeting.put(key, System.getProperty("plumb." + key));
      return greeting;
    }

    void answer(String ask, Map<?, ?> question, Map<String, Object> answer) throws Exception {
      if (framework == null)
        throw new Refused("no framework on the class path: looked for Scene in the packages " + Framework.ROOTS);
      if (ask.equals("load")) {
        scene = null;
        scene = new LoadedScene(framework, new File((String) question.get("scene")));
        answer.put("ok", true);
        return;
      }
      if (!Arrays.asList("surfaces", "bounds", "matrices", "average_positions", "closest", "any", "all").contains(ask))
        throw new Unsupported("the Java adapter does not answer '" + ask + "'");
      if (scene == null) throw new Refused("no scene has been loaded");
      if (ask.equals("matrices"))
        for (Leaf leaf : scene.leaves) leaf.showMatrixLayout();
      List<Object> list = new ArrayList<>();
      for (Leaf leaf : scene.leaves) {
        if (ask.equals("surfaces")) list.add(leaf.description());
        if (ask.equals("bounds")) list.add(leaf.bounds());
        if (ask.equals("matrices")) list.add(leaf.matrices());
        if (ask.equals("average_positions")) list.add(leaf.averagePosition());
      }
      if (question.get("rays") != null) {
        for (Object item : (List<?>) question.get("rays")) {
          double[] ray = numbers((List<?>) item);
          if (ask.equals("closest")) list.add(scene.closest(ray));
          if (ask.equals("any")) list.add(scene.any(ray) ? 1 : 0);
          if (ask.equals("all")) list.add(scene.all(ray));
        }
      }
      answer.put(ask.equals("closest") ? "hits" : ask, list);
    }

    private static double[] numbers(List<?> list) {
      double[] numbers = new double[list.size()];
      for (int i = 0; i < numbers.length; i++) {
        Object item = list.get(i);
        if (item instanceof Number)
          numbers[i] = ((Number) item).doubleValue();
        else
          numbers[i] = "inf".equals(item) ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
      }
      return numbers;
    }
  }

  // ------------------------------------------------------------------------------------------------ the framework

  /** The classes of one year's framework. They are found without running their static initialisers. */
  static final class Framework {
    // The later assignments first: a class path may hold the earlier one too.
    static final List<String> ROOTS = Arrays.asList("ray2", "cs4620.ray2", "ray", "ray1", "cs4620.ray1");
    private static final String[] PLACES = {"", "surface.", "surfaces.", "accel.", "util.", "misc.", "parser.", "io."};

    final String root;
    final Class<?> scene;
    final Class<?> surface;
    final Class<?> record;
    final Class<?> ray;
    private final Method intersect;
    private final boolean recordFirst;

    static Framework find() {
      String asked = System.getProperty("plumb.package");
      for (String root : asked == null ? ROOTS : Collections.singletonList(asked))
        if (load(root + ".Scene") != null) return new Framework(root);
      return null;
    }

    private Framework(String root) {
      this.root = root;
      scene = load(root + ".Scene");
      Method add = Members.method(scene, "addSurface", 1);
      surface = add != null ? add.getParameterTypes()[0] : find("Surface");
      intersect = surface == null ? null : Members.method(surface, "intersect", 2);
      if (intersect == null) {
        recordFirst = true;
        record = find("IntersectionRecord");
        ray = find("Ray");
      } else {
        Class<?>[] types = intersect.getParameterTypes();
        recordFirst = !types[0].getSimpleName().equals("Ray");
        record = types[recordFirst ? 0 : 1];
        ray = types[recordFirst ? 1 : 0];
      }
    }

    /** A class of the framework by its simple name; null if there is none. */
    Class<?> find(String name) {
      for (String place : PLACES) {
        Class<?> type = load(root + "." + place + name);
        if (type != null) return type;
      }
      return null;
    }

    private static Class<?> load(String name) {
      try {
        return Class.forName(name, false, PlumbProbe.class.getClassLoader());
      } catch (ClassNotFoundException | LinkageError e) {
        return null;
      }
    }

    void describe(Map<String, Object> greeting) {
      greeting.put("precision", precision(ray == null ? null : Members.field(ray, "origin")));
      greeting.put("t_precision", precision(record == null ? null : Members.field(record, "t")));
      Class<?> group = find("Group");
      greeting.put("surfaces", group == null || !childFields(group).isEmpty() ? "tree" : "flat");
      List<Object> shapes = new ArrayList<>();
      for (String name : new String[] {"Mesh", "Sphere", "Box", "Cylinder", "Cone"})
        if (find(name) != null) shapes.add(name.toLowerCase());
      greeting.put("shapes", shapes);
      List<Object> can = new ArrayList<>(Arrays.asList("normal", "any", "all"));
      if (surface != null && has("minBound") && has("maxBound")) can.add("bounds");
      if (surface != null && has("tMat") && has("tMatInv") && has("tMatTInv")) can.add("matrices");
      if (surface != null && has("averagePosition")) can.add("average_position");
      greeting.put("can", can);
    }

    private boolean has(String member) {
      return Members.getter(surface, member) != null || Members.field(surface, member) != null;
    }

    private static String precision(Field field) {
      if (field == null) return "double";
      if (field.getType().isPrimitive()) return field.getType() == float.class ? "float" : "double";
      Field x = Members.field(field.getType(), "x");
      return x != null && x.getType() == float.class ? "float" : "double";
    }

    /** The fields of a class that may hold surfaces; those of its own class first. */
    List<Field> childFields(Class<?> type) {
      List<Field> fields = new ArrayList<>();
      for (Class<?> c = type; c != null && c != surface && c != Object.class; c = c.getSuperclass())
        for (Field f : c.getDeclaredFields())
          if (!Modifier.isStatic(f.getModifiers())
              && (Collection.class.isAssignableFrom(f.getType())
                  || surface != null && f.getType().isArray()
                      && surface.isAssignableFrom(f.getType().getComponentType())))
            fields.add(Members.open(f));
      return fields;
    }

    /** What the year's Parser makes of a file, with the places told where that year looks for mesh files. */
    Object parse(File file) throws Exception {
      setFolder(file);
      Class<?> parser = find("Parser");
      if (parser == null) parser = load("ext.java.Parser");
      if (parser == null) throw new Unsupported("there is no class " + root + ".Parser");
      Method parse = Members.method(parser, "parse", 2);
      if (parse == null) throw new Unsupported(parser.getName() + " has no member parse(String, Class)");
      Object name = parse.getParameterTypes()[0] == File.class ? file : file.getPath();
      Object parsed = parse.invoke(Members.make(parser), name, scene);
      if (parsed == null) throw new Refused("the Parser returned nothing for " + file.getName());
      return parsed;
    }

    private void setFolder(File file) throws Exception {
      String folder = file.getAbsoluteFile().getParent();
      Class<?> tracer = find("RayTracer");
      if (tracer != null) {
        Field path = Members.field(tracer, "testFolderPath");
        if (path != null && Modifier.isStatic(path.getModifiers())) path.set(null, folder + "/");
        Field workspace = Members.field(tracer, "sceneWorkspace");
        if (workspace != null && Modifier.isStatic(workspace.getModifiers())) {
          Constructor<?> make = workspace.getType().getDeclaredConstructor(String.class, String.class);
          make.setAccessible(true);
          workspace.set(null, make.newInstance(folder, file.getName()));
        }
      }
      Class<?> holder = find("TestFolderPath");
      Method set = holder == null ? null : Members.method(holder, "set", 1);
      if (set != null) set.invoke(null, folder + "/");
    }

    boolean intersect(Object surface, Object record, Object ray) throws Exception {
      if (intersect == null)
        throw new Unsupported(root + "'s Surface has no member intersect(IntersectionRecord, Ray)");
      return (Boolean) (recordFirst ? intersect.invoke(surface, record, ray) : intersect.invoke(surface, ray, record));
    }

    Object makeRay(double[] ray) throws Exception {
      Object made = Members.make(this.ray);
      Triple.put(made, Members.need(this.ray, "origin"), ray[0], ray[1], ray[2]);
      Triple.put(made, Members.need(this.ray, "direction"), ray[3], ray[4], ray[5]);
      for (String[] names : new String[][] {{"start", "end"}, {"tMin", "tMax"}, {"tmin", "tmax"}, {"minT", "maxT"}}) {
        Field start = Members.field(this.ray, names[0]);
        Field end = Members.field(this.ray, names[1]);
        if (start == null || end == null) continue;
        start.set(made, Members.number(start.getType(), ray[6]));
        end.set(made, Members.number(end.getType(), ray[7]));
        return made;
      }
      if (ray[6] > 0 || ray[7] < Double.POSITIVE_INFINITY)
        throw new Unsupported(this.ray.getName() + " has no members start and end, so that a range cannot be asked");
      return made;
    }
  }

  // ---------------------------------------------------------------------------------------------------- the scene

  /** One surface element of the file (or, where groups cannot be walked, one that the scene renders). */
  static final class Leaf {
    private final Object surface;
    private final String type;
    private final String path;
    /** What is rendered for it: itself, or the triangles of a mesh. */
    final List<Object> parts;

    Leaf(Object surface, String type, String path, List<Object> parts) {
      this.surface = surface;
      this.type = type;
      this.path = path;
      this.parts = parts;
    }

    boolean isMesh() {
      return type.equals("Mesh");
    }

    private boolean isSplit() {
      return parts.size() != 1 || parts.get(0) != surface;
    }

    Map<String, Object> description() throws Exception {
      Map<String, Object> description = new LinkedHashMap<>();
      description.put("type", type);
      if (path != null) description.put("path", path);
      try {
        description.put("numbers", numbers());
      } catch (Unsupported e) {
        if (path == null) throw e; // without a path the numbers are what it is known by
      }
      return description;
    }

    private List<Object> numbers() throws Exception {
      List<Object> numbers = new ArrayList<>();
      if (type.equals("Sphere")) collect(numbers, "center", "radius");
      if (type.equals("Box")) collect(numbers, "minPt", "maxPt");
      if (type.equals("Cylinder")) collect(numbers, "center", "radius", "height");
      if (type.equals("Cone")) collect(numbers, "center", "tipz", "radius", "height");
      if (isMesh() && isSplit()) numbers.add(parts.size());
      if (isMesh() && !isSplit()) collect(numbers, "numTriangles");
      return numbers;
    }

    private void collect(List<Object> numbers, String... members) throws Exception {
      for (String member : members) {
        Object value = Members.get(surface, member);
        if (value instanceof Number)
          numbers.add(((Number) value).doubleValue());
        else
          for (double x : Triple.read(value)) numbers.add(x);
      }
    }

    /** The surface's own box; a mesh's is that of its triangles, which are what the hierarchy is built of. */
    double[] bounds() throws Exception {
      if (!isSplit()) return box(surface);
      if (!isMesh() && Members.getIfThere(surface, "minBound") != null) return box(surface);
      double[] all = null;
      for (Object part : parts) {
        double[] box = box(part);
        if (all == null) all = box;
        for (int i = 0; i < 3; i++) {
          all[i] = Math.min(all[i], box[i]);
          all[i + 3] = Math.max(all[i + 3], box[i + 3]);
        }
      }
      if (all == null) throw new Refused("a mesh has no triangles");
      return all;
    }

    private static double[] box(Object surface) throws Exception {
      double[] low = Triple.read(computed(surface, "minBound"));
      double[] high = Triple.read(computed(surface, "maxBound"));
      return new double[] {low[0], low[1], low[2], high[0], high[1], high[2]};
    }

    /** What computeBoundingBox() leaves in a member; it is called if nothing has called it yet. */
    private static Object computed(Object surface, String member) throws Exception {
      Object value = Members.get(surface, member);
      if (value != null) return value;
      Method compute = Members.method(surface.getClass(), "computeBoundingBox", 0);
      if (compute == null) throw new Unsupported(surface.getClass().getName() + " has no member computeBoundingBox()");
      compute.invoke(surface);
      value = Members.get(surface, member);
      if (value == null)
        throw new Refused("computeBoundingBox() of " + surface.getClass().getName() + " left " + member + " null");
      return value;
    }

    /** A mesh's is the mean of its triangles', or the first of them that lies outside of its own triangle's box. */
    double[] averagePosition() throws Exception {
      if (!isSplit()) return Triple.read(computed(surface, "averagePosition"));
      if (!isMesh() && Members.getIfThere(surface, "averagePosition") != null)
        return Triple.read(computed(surface, "averagePosition"));
      double[] mean = new double[3];
      for (Object part : parts) {
        double[] position = Triple.read(computed(part, "averagePosition"));
        double[] box = box(part);
        for (int i = 0; i < 3; i++) {
          if (!(box[i] <= position[i] && position[i] <= box[i + 3])) return position;
          mean[i] += position[i] / parts.size();
        }
      }
      return mean;
    }

    Map<String, Object> matrices() throws Exception {
      Map<String, Object> matrices = new LinkedHashMap<>();
      matrices.put("world", matrix("tMat", 4));
      matrices.put("inverse", matrix("tMatInv", 4));
      matrices.put("inverse_transpose", matrix("tMatTInv", 3));
      return matrices;
    }

    /** To be called for all surfaces before matrices() is called for one. */
    void showMatrixLayout() throws Exception {
      for (String member : new String[] {"tMat", "tMatInv"}) {
        Object matrix = member(member);
        MatrixLayout.of(matrix.getClass()).learn(matrix);
      }
    }

    private Object member(String name) throws Exception {
      Object value = Members.get(surface, name);
      if (value == null && !parts.isEmpty()) value = Members.get(parts.get(0), name);
      if (value == null) throw new Refused(name + " of a " + surface.getClass().getName() + " is null");
      return value;
    }

    private double[] matrix(String member, int columns) throws Exception {
      Object matrix = member(member);
      MatrixLayout layout = MatrixLayout.of(matrix.getClass());
      double[] numbers = new double[3 * columns];
      for (int i = 0; i < numbers.length; i++) numbers[i] = layout.at(matrix, i / columns, i % columns);
      return numbers;
    }
  }

  /** A scene that the framework has parsed, transformed, and put under its hierarchy. */
  static final class LoadedScene {
    private final Framework framework;
    private final Object scene;
    final List<Leaf> leaves = new ArrayList<>();
    /** Whose part a rendered surface is: the place of the leaf, the number of the part. */
    private final Map<Object, int[]> places = new IdentityHashMap<>();
    /** The same by what a triangle is made of, for frameworks that make their triangles anew. */
    private final Map<Object, Map<Object, int[]>> trianglePlaces = new IdentityHashMap<>();
    /** What answers getFirstIntersection(record, ray) or intersect(record, ray, false); null for none. */
    private final Object tracer;

    LoadedScene(Framework framework, File file) throws Exception {
      this.framework = framework;
      scene = framework.parse(file);
      List<Object> surfaces = new ArrayList<>((Collection<?>) Members.get(scene, "surfaces"));
      if (!callOneOf(scene, "setTransform", "initTransform")) callOneOf(scene, "init");
      walk(surfaces, "");
      for (int i = 0; i < leaves.size(); i++) {
        List<Object> parts = leaves.get(i).parts;
        for (int p = 0; p < parts.size(); p++) place(parts.get(p), new int[] {i, p});
      }
      tracer = buildHierarchy() ? findTracer() : null;
    }

    private static boolean callOneOf(Object on, String... names) throws Exception {
      for (String name : names) {
        Method method = Members.method(on.getClass(), name, 0);
        if (method == null) continue;
        method.invoke(on);
        return true;
      }
      return false;
    }

    private void walk(Collection<?> surfaces, String above) throws Exception {
      int i = 0;
      for (Object surface : surfaces) {
        String path = above + i++;
        if (!typeName(surface).equals("Group")) {
          leaves.add(new Leaf(surface, typeName(surface), path, rendered(surface)));
          continue;
        }
        Collection<?> members = members(surface);
        if (members != null)
          walk(members, path + "/");
        else
          flatten(rendered(surface));
      }
    }

    /** The members of a group in file order, or null if it does not show them. */
    private Collection<?> members(Object group) throws Exception {
      for (Field field : framework.childFields(group.getClass())) {
        Object value = field.get(group);
        if (value instanceof Object[]) value = Arrays.asList((Object[]) value);
        boolean surfaces = value instanceof Collection;
        if (surfaces)
          for (Object item : (Collection<?>) value) surfaces &= framework.surface.isInstance(item);
        if (surfaces) return (Collection<?>) value;
      }
      return null;
    }

    private List<Object> rendered(Object surface) throws Exception {
      List<Object> list = new ArrayList<>();
      Method append = Members.method(surface.getClass(), "appendRenderableSurfaces", 1);
      if (append == null)
        list.add(surface);
      else
        append.invoke(surface, list);
      return list;
    }

    /** Surfaces whose groups are lost; the triangles of one mesh become that mesh again. */
    private void flatten(List<Object> surfaces) throws Exception {
      Map<Object, List<Object>> meshes = new IdentityHashMap<>();
      for (Object surface : surfaces) {
        Object owner = typeName(surface).equals("Triangle") ? Members.getIfThere(surface, "owner") : null;
        if (owner == null) {
          leaves.add(new Leaf(surface, typeName(surface), null, new ArrayList<>(Collections.singletonList(surface))));
          continue;
        }
        if (!meshes.containsKey(owner)) {
          meshes.put(owner, new ArrayList<>());
          leaves.add(new Leaf(owner, "Mesh", null, meshes.get(owner)));
        }
        meshes.get(owner).add(surface);
      }
    }

    private static String typeName(Object surface) {
      List<String> known = Arrays.asList("Sphere", "Box", "Cylinder", "Cone", "Mesh", "Triangle", "Group");
      for (Class<?> c = surface.getClass(); c != null; c = c.getSuperclass()) {
        String name = c.getSimpleName();
        if (known.contains(name)) return name;
        // One year calls a single triangle of a mesh so.
        if (name.equals("TriangleMesh")) return Members.field(c, "owner") != null ? "Triangle" : "Mesh";
      }
      return surface.getClass().getSimpleName();
    }

    /** A surface that stands in the scene twice (by ref) is one object, and keeps its first place. */
    private void place(Object part, int[] place) throws Exception {
      places.putIfAbsent(part, place);
      Object owner = Members.getIfThere(part, "owner");
      if (owner == null) return;
      trianglePlaces.computeIfAbsent(owner, o -> new HashMap<>()).putIfAbsent(triangleKey(part), place);
    }

    private static Object triangleKey(Object triangle) throws Exception {
      Object index = Members.getIfThere(triangle, "index");
      if (index instanceof int[]) return Arrays.toString((int[]) index);
      if (index != null) return Arrays.toString(Triple.read(index));
      Object face = Members.getIfThere(triangle, "face");
      return face == null ? triangle : face;
    }

    private int[] placeOf(Object surface) throws Exception {
      if (surface == null) throw new Refused("a hit was reported, but the record's surface is null");
      int[] place = places.get(surface);
      Object owner = place == null ? Members.getIfThere(surface, "owner") : null;
      if (owner != null && trianglePlaces.containsKey(owner))
        place = trianglePlaces.get(owner).get(triangleKey(surface));
      if (place == null)
        throw new Refused("a hit's surface, a " + surface.getClass().getName() + ", is not in the scene");
      return place;
    }

    /** Builds the subject's own hierarchy as its year does it; false if there is one that cannot be built. */
    private boolean buildHierarchy() throws Exception {
      List<Object> all = new ArrayList<>();
      for (Leaf leaf : leaves) all.addAll(leaf.parts);
      Object array = all.toArray((Object[]) Array.newInstance(framework.surface, 0));
      if (callOneOf(scene, "initializeAABB")) return true;
      Field field = Members.field(scene.getClass(), "accelStruct");
      if (field == null) return true;
      Object hierarchy = field.get(scene);
      if (hierarchy == null) {
        Class<?> bvh = framework.find("Bvh");
        if (bvh == null) return false;
        Constructor<?> make = null;
        for (Constructor<?> c : bvh.getDeclaredConstructors())
          if (c.getParameterCount() == 3 && c.getParameterTypes()[0].isArray()) make = c;
        if (make != null) make.setAccessible(true);
        hierarchy = make != null ? make.newInstance(array, 0, all.size()) : Members.make(bvh);
        field.set(scene, hierarchy);
      }
      Method build = Members.method(hierarchy.getClass(), "build", 1);
      if (build != null) {
        build.invoke(hierarchy, array);
        return true;
      }
      Method set = Members.method(hierarchy.getClass(), "setSurfaces", 1);
      if (set != null) set.invoke(hierarchy, array);
      return callOneOf(hierarchy, "build");
    }

    private Object findTracer() throws Exception {
      if (Members.method(scene.getClass(), "getFirstIntersection", 2) != null) return scene;
      Object hierarchy = Members.getIfThere(scene, "accelStruct");
      return hierarchy != null && Members.method(hierarchy.getClass(), "intersect", 3) != null ? hierarchy : null;
    }

    Map<String, Object> closest(double[] query) throws Exception {
      if (tracer == null) return closestOfAll(query);
      Object record = Members.make(framework.record);
      Object ray = framework.makeRay(query);
      Method method = Members.method(tracer.getClass(), "getFirstIntersection", 2);
      boolean hit = (Boolean) (method != null
              ? method.invoke(tracer, record, ray)
              : Members.method(tracer.getClass(), "intersect", 3).invoke(tracer, record, ray, false));
      return hit ? hit(placeOf(Members.get(record, "surface")), record) : null;
    }

    private Map<String, Object> closestOfAll(double[] query) throws Exception {
      Map<String, Object> best = null;
      for (Leaf leaf : leaves) {
        for (Object part : leaf.parts) {
          Object record = Members.make(framework.record);
          if (!framework.intersect(part, record, framework.makeRay(query))) continue;
          Map<String, Object> hit = hit(places.get(part), record);
          if (best == null || (Double) hit.get("t") < (Double) best.get("t")) best = hit;
        }
      }
      return best;
    }

    boolean any(double[] query) throws Exception {
      Method one = Members.method(scene.getClass(), "getAnyIntersection", 1);
      Method two = Members.method(scene.getClass(), "getAnyIntersection", 2);
      if (tracer == scene && one != null) return (Boolean) one.invoke(scene, framework.makeRay(query));
      if (tracer == scene && two != null)
        return (Boolean) two.invoke(scene, Members.make(framework.record), framework.makeRay(query));
      return closest(query) != null;
    }

    /** Each surface's own intersect is asked again past each hit, for it answers one hit at a time. */
    List<Object> all(double[] query) throws Exception {
      final int mostHits = 16; // of one surface; a surface that ignores the ray's start would answer for ever
      List<Object> hits = new ArrayList<>();
      for (Leaf leaf : leaves) {
        for (Object part : leaf.parts) {
          double[] rest = query.clone();
          for (int i = 0; i < mostHits; i++) {
            Object record = Members.make(framework.record);
            if (!framework.intersect(part, record, framework.makeRay(rest))) break;
            Map<String, Object> hit = hit(places.get(part), record);
            double t = (Double) hit.get("t");
            if (!(rest[6] <= t && t <= rest[7])) break;
            hits.add(hit);
            boolean single = Members.need(framework.record, "t").getType() == float.class;
            rest[6] = single ? Math.nextUp((float) t) : Math.nextUp(t);
          }
        }
      }
      return hits;
    }

    private Map<String, Object> hit(int[] place, Object record) throws Exception {
      Map<String, Object> hit = new LinkedHashMap<>();
      hit.put("s", place[0]);
      if (leaves.get(place[0]).isMesh()) hit.put("p", place[1]);
      hit.put("t", ((Number) Members.get(record, "t")).doubleValue());
      Object normal = Members.getIfThere(record, "normal");
      if (normal != null) hit.put("n", Triple.read(normal));
      return hit;
    }
  }

  // ------------------------------------------------------------------------------------------ members, by their names

  /** Finds members by name in a class and those above it, whatever their access, and remembers them. */
  static final class Members {
    private static final Map<Class<?>, Map<String, Field>> FIELDS = new HashMap<>();
    private static final Map<Class<?>, Map<String, Method>> METHODS = new HashMap<>();
    private static final Map<Class<?>, Constructor<?>> MAKERS = new HashMap<>();

    private Members() {}

    static Field open(Field field) {
      field.setAccessible(true);
      return field;
    }

    /** Null if there is none. */
    static Field field(Class<?> type, String name) {
      Map<String, Field> known = FIELDS.computeIfAbsent(type, t -> new HashMap<>());
      if (known.containsKey(name)) return known.get(name);
      Field found = null;
      for (Class<?> c = type; c != null && found == null; c = c.getSuperclass())
        for (Field f : c.getDeclaredFields())
          if (f.getName().equals(name)) found = open(f);
      known.put(name, found);
      return found;
    }

    static Field need(Class<?> type, String name) {
      Field found = field(type, name);
      if (found == null) throw new Unsupported(type.getName() + " has no member " + name);
      return found;
    }

    /** Null if there is none. Of several with this number of parameters, one that a subclass declares comes first. */
    static Method method(Class<?> type, String name, int parameters) {
      Map<String, Method> known = METHODS.computeIfAbsent(type, t -> new HashMap<>());
      String key = name + "/" + parameters;
      if (known.containsKey(key)) return known.get(key);
      List<Method> candidates = new ArrayList<>();
      for (Class<?> c = type; c != null; c = c.getSuperclass())
        candidates.addAll(Arrays.asList(c.getDeclaredMethods()));
      candidates.addAll(Arrays.asList(type.getMethods())); // those of interfaces
      Method found = null;
      for (Method m : candidates)
        if (found == null && m.getName().equals(name) && m.getParameterCount() == parameters && !m.isBridge())
          found = m;
      if (found != null) found.setAccessible(true);
      known.put(key, found);
      return found;
    }

    static Method getter(Class<?> type, String name) {
      Method found = method(type, "get" + Character.toUpperCase(name.charAt(0)) + name.substring(1), 0);
      return found != null && found.getReturnType() != void.class ? found : null;
    }

    /** By the getter, which is what the subject's own code uses, or the field. */
    static Object get(Object on, String name) throws Exception {
      Method getter = getter(on.getClass(), name);
      return getter != null ? getter.invoke(on) : need(on.getClass(), name).get(on);
    }

    static Object getIfThere(Object on, String name) throws Exception {
      return getter(on.getClass(), name) != null || field(on.getClass(), name) != null ? get(on, name) : null;
    }

    static Object make(Class<?> type) throws Exception {
      if (!MAKERS.containsKey(type)) {
        Constructor<?> maker = null;
        for (Constructor<?> c : type.getDeclaredConstructors())
          if (c.getParameterCount() == 0) maker = c;
        if (maker != null) maker.setAccessible(true);
        MAKERS.put(type, maker);
      }
      Constructor<?> maker = MAKERS.get(type);
      if (maker != null) return maker.newInstance();
      // A Ray(Point3, Vector3): the numbers are put in afterwards.
      for (Constructor<?> c : type.getDeclaredConstructors()) {
        List<Object> vectors = new ArrayList<>();
        for (Class<?> parameter : c.getParameterTypes())
          if (Triple.isOne(parameter)) vectors.add(Triple.make(parameter, 0, 0, 1));
        if (vectors.size() != c.getParameterCount()) continue;
        c.setAccessible(true);
        return c.newInstance(vectors.toArray());
      }
      throw new Unsupported(type.getName() + " has no constructor without parameters");
    }

    static Object number(Class<?> type, double value) {
      if (type == float.class || type == Float.class) return (float) value;
      return value;
    }

    static boolean isNumber(Class<?> type) {
      return type == double.class || type == float.class;
    }
  }

  /** Points and vectors: three fields x, y, z; or an array of numbers; or three methods x(), getX(). */
  static final class Triple {
    private Triple() {}

    private static final String[] NAMES = {"x", "y", "z"};

    private static Field array(Class<?> type) {
      for (Class<?> c = type; c != null; c = c.getSuperclass())
        for (Field f : c.getDeclaredFields())
          if ((f.getType() == double[].class || f.getType() == float[].class) && !Modifier.isStatic(f.getModifiers()))
            return Members.open(f);
      return null;
    }

    static double[] read(Object value) throws Exception {
      double[] read = new double[3];
      Class<?> type = value.getClass();
      for (int i = 0; i < 3; i++) {
        Field field = Members.field(type, NAMES[i]);
        Method method = field != null ? null : Members.method(type, NAMES[i], 0);
        if (field == null && method == null) method = Members.getter(type, NAMES[i]);
        if (field != null)
          read[i] = ((Number) field.get(value)).doubleValue();
        else if (method != null)
          read[i] = ((Number) method.invoke(value)).doubleValue();
        else if (array(type) != null)
          read[i] = Array.getDouble(array(type).get(value), i);
        else
          throw new Unsupported(type.getName() + " has no member " + NAMES[i]);
      }
      return read;
    }

    static boolean isOne(Class<?> type) {
      Field x = Members.field(type, "x");
      return x != null && Members.isNumber(x.getType()) && Members.field(type, "z") != null
          && Members.field(type, "w") == null
          || x == null && !type.isPrimitive() && array(type) != null;
    }

    private static Constructor<?> maker(Class<?> type) {
      for (Constructor<?> c : type.getDeclaredConstructors()) {
        Class<?>[] types = c.getParameterTypes();
        if (types.length != 3 || !Members.isNumber(types[0]) || !Members.isNumber(types[2])) continue;
        c.setAccessible(true);
        return c;
      }
      return null;
    }

    static Object make(Class<?> type, double x, double y, double z) throws Exception {
      Constructor<?> maker = maker(type);
      if (maker != null) {
        Class<?> number = maker.getParameterTypes()[0];
        return maker.newInstance(Members.number(number, x), Members.number(number, y), Members.number(number, z));
      }
      Object made = Members.make(type);
      if (!write(made, x, y, z)) throw new Unsupported(type.getName() + " has no constructor of three numbers");
      return made;
    }

    /** Puts numbers into a vector that another object holds: in place, or by a new vector. Nothing is normalised. */
    static void put(Object holder, Field field, double x, double y, double z) throws Exception {
      Object held = field.get(holder);
      if (held == null || !write(held, x, y, z)) field.set(holder, make(field.getType(), x, y, z));
    }

    private static boolean write(Object value, double... numbers) throws Exception {
      Class<?> type = value.getClass();
      Field array = Members.field(type, "x") == null ? array(type) : null;
      for (int i = 0; i < 3; i++) {
        Field field = Members.field(type, NAMES[i]);
        if (field != null && !Modifier.isFinal(field.getModifiers()))
          field.set(value, Members.number(field.getType(), numbers[i]));
        else if (array == null)
          return false;
        else
          Array.set(array.get(value), i, Members.number(array.getType().getComponentType(), numbers[i]));
      }
      return true;
    }
  }

  /**
   * Where a class of matrices keeps its numbers: an array of rows, an array of all, or fields m00..m33 (or m11..m44),
   * by rows or by columns. Which of them is right shows by a translation that the class itself makes.
   */
  static final class MatrixLayout {
    private interface Numbers {
      double at(Object matrix, int row, int column) throws Exception;
    }

    private static final Map<Class<?>, MatrixLayout> KNOWN = new HashMap<>();

    private final Numbers numbers;
    /** Where the class cannot make a translation, the first matrix that holds one shows the order. */
    private boolean unsure;
    private boolean columnsFirst;

    private MatrixLayout(Numbers numbers, boolean unsure) {
      this.numbers = numbers;
      this.unsure = unsure;
    }

    static MatrixLayout of(Class<?> type) throws Exception {
      if (!KNOWN.containsKey(type)) KNOWN.put(type, find(type));
      return KNOWN.get(type);
    }

    double at(Object matrix, int row, int column) throws Exception {
      return columnsFirst ? numbers.at(matrix, column, row) : numbers.at(matrix, row, column);
    }

    /** Learns the order of the class from a matrix that is not a linear one: its last row is 0 0 0 1. */
    void learn(Object matrix) throws Exception {
      boolean rows = false;
      boolean columns = false;
      for (int i = 0; unsure && i < 3; i++) {
        rows |= numbers.at(matrix, i, 3) != 0;
        columns |= numbers.at(matrix, 3, i) != 0;
      }
      if (rows == columns) return;
      columnsFirst = columns;
      unsure = false;
    }

    private static MatrixLayout find(Class<?> type) throws Exception {
      List<Numbers> candidates = candidates(type);
      if (candidates.isEmpty()) throw new Unsupported(type.getName() + " has no member m with its numbers");
      Object translation = translation(type);
      if (translation == null) return new MatrixLayout(candidates.get(0), true);
      for (Numbers plain : candidates)
        for (Numbers order : new Numbers[] {plain, (m, r, c) -> plain.at(m, c, r)})
          if (isTranslation(order, translation)) return new MatrixLayout(order, false);
      throw new Unsupported("where " + type.getName() + " keeps its numbers could not be found out");
    }

    private static boolean isTranslation(Numbers numbers, Object matrix) throws Exception {
      try {
        return numbers.at(matrix, 0, 3) == 2 && numbers.at(matrix, 1, 3) == 3 && numbers.at(matrix, 2, 3) == 5;
      } catch (IndexOutOfBoundsException e) {
        return false;
      }
    }

    private static List<Numbers> candidates(Class<?> type) {
      List<Numbers> found = new ArrayList<>();
      for (Class<?> c = type; c != null; c = c.getSuperclass()) {
        for (Field f : c.getDeclaredFields()) {
          if (Modifier.isStatic(f.getModifiers())) continue;
          Field field = Members.open(f);
          Numbers numbers = null;
          if (f.getType() == double[][].class || f.getType() == float[][].class)
            numbers = (m, row, column) -> Array.getDouble(Array.get(field.get(m), row), column);
          if (f.getType() == double[].class || f.getType() == float[].class)
            numbers = (m, row, column) -> Array.getDouble(field.get(m), 4 * row + column);
          if (numbers != null) found.add(f.getName().equals("m") ? 0 : found.size(), numbers);
          for (int first = 0; first <= 1; first++) {
            String corner = "" + first + first;
            if (!Members.isNumber(f.getType()) || !f.getName().endsWith(corner)) continue;
            String name = f.getName().substring(0, f.getName().length() - 2);
            int base = first;
            // m11 is the first of all only where there is no m00.
            if (Members.field(type, name + (base + 2) + (base + 3)) == null
                || base == 1 && Members.field(type, name + "00") != null)
              continue;
            found.add((m, row, column)
                          -> ((Number) Members.need(m.getClass(), name + (row + base) + (column + base)).get(m))
                                 .doubleValue());
          }
        }
      }
      return found;
    }

    /** The translation by (2, 3, 5) that the class makes, or null. */
    private static Object translation(Class<?> type) throws Exception {
      List<String> setters = Arrays.asList("setTranslate", "setTranslation", "setToTranslation");
      List<String> makers = Arrays.asList("createTranslation", "createTranslate", "translation", "translate");
      for (Method method : type.getDeclaredMethods()) {
        boolean isStatic = Modifier.isStatic(method.getModifiers());
        if (!(isStatic ? makers : setters).contains(method.getName())) continue;
        Class<?>[] types = method.getParameterTypes();
        Object[] arguments;
        if (types.length == 1 && Triple.isOne(types[0])) {
          arguments = new Object[] {Triple.make(types[0], 2, 3, 5)};
        } else if (types.length == 3 && Members.isNumber(types[0])) {
          arguments =
              new Object[] {Members.number(types[0], 2), Members.number(types[0], 3), Members.number(types[0], 5)};
        } else {
          continue;
        }
        method.setAccessible(true);
        if (isStatic) return method.invoke(null, arguments);
        Object made = Members.make(type);
        method.invoke(made, arguments);
        return made;
      }
      return null;
    }
  }

  // --------------------------------------------------------------------------------------------------------- JSON

  /** Reads one value: objects become maps, arrays lists, numbers doubles (long where they are whole). */
  static final class JsonReader {
    private final String text;
    private int at;

    JsonReader(String text) {
      this.text = text;
    }

    Object read() {
      char c = next();
      if (c == '{') return readObject();
      if (c == '[') return readList();
      if (c == '"') return readString();
      int end = --at;
      while (end < text.length() && ",]} \t\r\n".indexOf(text.charAt(end)) < 0) end++;
      String word = text.substring(at, end);
      at = end;
      if (word.equals("true") || word.equals("false")) return word.equals("true");
      if (word.equals("null")) return null;
      boolean whole = word.length() < 16 && !word.equals("-0");
      for (int i = 0; i < word.length(); i++)
        whole &= Character.isDigit(word.charAt(i)) || i == 0 && word.charAt(0) == '-';
      return whole ? (Object) Long.valueOf(word) : (Object) Double.valueOf(word);
    }

    /** The next character that is no white space. */
    private char next() {
      while (" \t\r\n".indexOf(text.charAt(at)) >= 0) at++;
      return text.charAt(at++);
    }

    private Map<String, Object> readObject() {
      Map<String, Object> map = new HashMap<>();
      for (char c = next(); c != '}'; c = next()) {
        if (c == ',') continue;
        String key = readString();
        if (next() != ':') throw new IllegalArgumentException("a question is not JSON");
        map.put(key, read());
      }
      return map;
    }

    private List<Object> readList() {
      List<Object> list = new ArrayList<>();
      for (char c = next(); c != ']'; c = next()) {
        if (c == ',') continue;
        at--;
        list.add(read());
      }
      return list;
    }

    /** From behind the opening quote. */
    private String readString() {
      StringBuilder value = new StringBuilder();
      for (char c = text.charAt(at++); c != '"'; c = text.charAt(at++)) {
        if (c != '\\') {
          value.append(c);
          continue;
        }
        char escaped = text.charAt(at++);
        if (escaped == 'u') {
          value.append((char) Integer.parseInt(text.substring(at, at + 4), 16));
          at += 4;
        } else {
          int control = "bfnrt".indexOf(escaped);
          value.append(control < 0 ? escaped : "\b\f\n\r\t".charAt(control));
        }
      }
      return value.toString();
    }
  }

  /** Writes maps, lists, arrays of numbers, numbers, texts, truth values and null. */
  static final class JsonWriter {
    private JsonWriter() {}

    static void write(StringBuilder out, Object value) {
      if (value instanceof Map) {
        String separator = "{";
        for (Map.Entry<?, ?> entry : ((Map<?, ?>) value).entrySet()) {
          out.append(separator);
          quote(out, (String) entry.getKey());
          out.append(':');
          write(out, entry.getValue());
          separator = ",";
        }
        out.append('}');
      } else if (value instanceof List) {
        String separator = "";
        out.append('[');
        for (Object item : (List<?>) value) {
          out.append(separator);
          write(out, item);
          separator = ",";
        }
        out.append(']');
      } else if (value instanceof double[]) {
        List<Object> list = new ArrayList<>();
        for (double x : (double[]) value) list.add(x);
        write(out, list);
      } else if (value instanceof Double) {
        double x = (Double) value;
        if (Double.isNaN(x))
          out.append("\"nan\"");
        else if (Double.isInfinite(x))
          out.append(x > 0 ? "\"inf\"" : "\"-inf\"");
        else
          out.append(x); // Double.toString round-trips
      } else if (value instanceof String) {
        quote(out, (String) value);
      } else {
        out.append(value);
      }
    }

    private static void quote(StringBuilder out, String text) {
      out.append('"');
      for (char c : text.toCharArray()) {
        if (c == '"' || c == '\\')
          out.append('\\').append(c);
        else if (c < 0x20 || Character.isSurrogate(c))
          out.append(String.format("\\u%04x", (int) c));
        else
          out.append(c);
      }
      out.append('"');
    }
  }
}
