// The shapes in which the framework came over the years, made of the example by changing its text.
#include "tools/adapters/java_scene.h"

namespace plumb {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr double kTolerance = 1e-12;      // as in java_probe_test.cpp
constexpr double kFloatTolerance = 1e-4;  // 50 * 20 * 2^-24 < 6e-5

/// Moves the framework to another package; the folders need not follow for javac.
void rename_package(JavaProgram& program, const std::string& package) {
  program.replace_everywhere("package ray", "package " + package);
  program.replace_everywhere("import ray.", "import " + package + ".");
  program.replace_everywhere("\"ray.", "\"" + package + ".");
}

TEST(JavaYears, PackageRay2) {
  JavaProgram program;
  rename_package(program, "ray2");
  program.compile();
  const std::vector<json> answers = program.ask(java_questions(program));
  EXPECT_EQ(answers[0]["name"], "java-ray2");
  expect_right_answers(answers, kTolerance);
}

TEST(JavaYears, PackageCs4620WithTheMathElsewhereAndMatricesByColumns) {
  JavaProgram program;
  rename_package(program, "cs4620.ray2");
  program.replace_everywhere("cs4620.ray2.math", "egl.math");
  program.replace("ray/math/Matrix4.java", "private final double[][] m = new double[4][4];",
                  "private final double[] spare = new double[16]; public final double[] m = new double[16];");
  program.replace("ray/math/Matrix4.java", "m[row][column]", "m[4 * column + row]");
  program.compile();
  const std::vector<json> answers = program.ask(java_questions(program));
  EXPECT_EQ(answers[0]["name"], "java-cs4620.ray2");
  expect_right_answers(answers, kTolerance);
}

TEST(JavaYears, MatricesByColumnsWithoutAWayToMakeATranslation) {
  JavaProgram program;
  program.replace_everywhere("setTranslate(", "addMove(");  // the group's tag too, hence:
  program.replace("ray/surface/Group.java", "public void addMove(", "public void setTranslate(");
  program.replace("ray/math/Matrix4.java", "m[row][column]", "m[column][row]");
  program.compile();
  expect_right_answers(program.ask(java_questions(program)), kTolerance);
}

TEST(JavaYears, MatricesOfNamedFields) {
  JavaProgram program;
  program.replace("ray/math/Matrix4.java", "private final double[][] m = new double[4][4];", R"(
    double m00, m01, m02, m03, m10, m11, m12, m13, m20, m21, m22, m23, m30, m31, m32, m33;
    private java.lang.reflect.Field at(int row, int column) {
        try { return Matrix4.class.getDeclaredField("m" + row + column); } catch (ReflectiveOperationException e) { throw new Error(e); }
    })");
  program.replace(
      "ray/math/Matrix4.java", "return m[row][column];",
      "try { return at(row, column).getDouble(this); } catch (ReflectiveOperationException e) { throw new Error(e); }");
  program.replace(
      "ray/math/Matrix4.java", "m[row][column] = value;",
      "try { at(row, column).setDouble(this, value); } catch (ReflectiveOperationException e) { throw new Error(e); }");
  program.compile();
  expect_right_answers(program.ask(java_questions(program)), kTolerance);
}

TEST(JavaYears, SinglePrecision) {
  JavaProgram program;
  program.replace("ray/math/Tuple3.java", "public double ", "public float ");
  for (const char* name : {"x", "y", "z"})
    program.replace("ray/math/Tuple3.java", std::string("this.") + name + " = ",
                    std::string("this.") + name + " = (float) ");
  program.replace("ray/math/Tuple3.java", "public float get", "public double get");
  program.replace("ray/math/Matrix4.java", "private final double[][] m = new double[4][4];",
                  "private final float[][] m = new float[4][4];");
  program.replace("ray/math/Matrix4.java", "m[row][column] = value", "m[row][column] = (float) value");
  program.replace("ray/IntersectionRecord.java", "public double t;", "public float t;");
  program.replace("ray/surface/Surface.java", "record.t = t;", "record.t = (float) t;");
  program.compile();
  const std::vector<json> answers = program.ask(java_questions(program));
  EXPECT_EQ(answers[0]["precision"], "float");
  EXPECT_EQ(answers[0]["t_precision"], "float");
  expect_right_answers(answers, kFloatTolerance);
}

TEST(JavaYears, TheHierarchyIsTheScenesOwnAndTrianglesAreMadeAnew) {
  JavaProgram program;
  program.replace("ray/Scene.java", "protected AccelStruct accelStruct = new Bvh();", R"(protected AccelStruct tree;
    public void initializeAABB() {
        List<Surface> all = new ArrayList<>();
        for (Surface surface : surfaces) surface.appendRenderableSurfaces(all);
        tree = new Bvh();
        tree.build(all.toArray(new Surface[0]));
    })");
  program.replace("ray/Scene.java", "return accelStruct;", "return tree;");
  program.replace("ray/Scene.java", "accelStruct.", "tree.");
  program.replace("ray/surface/Mesh.java", "list.add(triangle);",
                  "Triangle fresh = new Triangle(this, triangle.index); list.add(fresh);"
                  "fresh.setTransformation(tMat, tMatInv, tMatTInv);");
  program.replace("ray/Scene.java", "void setTransform()", "void initTransform()");
  program.compile();
  expect_right_answers(program.ask(java_questions(program)), kTolerance);
}

TEST(JavaYears, TheHierarchyIsMadeByWhoeverRenders) {
  JavaProgram program;
  program.replace("ray/Scene.java", "protected AccelStruct accelStruct = new Bvh();",
                  "protected AccelStruct accelStruct;");
  program.replace("ray/accel/AccelStruct.java", "void build(Surface[] surfaces);", "void build();");
  program.replace(
      "ray/accel/Bvh.java", "public void build(Surface[] all) {",
      "public void build() { build(surfaces); } public Bvh(Surface[] all, int from, int to) { surfaces = all; }"
      " private void build(Surface[] all) {");
  program.replace("ray/accel/Bvh.java", "@Override\n    public void build()", "public void build()");
  program.compile();
  expect_right_answers(program.ask(java_questions(program)), kTolerance);
}

TEST(JavaYears, WithoutAHierarchyAllSurfacesAreAsked) {
  JavaProgram program;
  program.replace("ray/Scene.java", "protected AccelStruct accelStruct = new Bvh();",
                  "protected AccelStruct accelStruct;");
  program.replace("ray/accel/Bvh.java", "public class Bvh", "class Hidden");
  program.replace("ray/Scene.java", "import ray.accel.Bvh;", "");
  program.compile();
  expect_right_answers(program.ask(java_questions(program)), kTolerance);
}

TEST(JavaYears, MeshFilesAreSoughtWhereTheRayTracerSays) {
  JavaProgram program;
  program.write("src/ray/RayTracer.java",
                "package ray; public class RayTracer { public static String testFolderPath; }");
  program.replace("ray/surface/Mesh.java", "public void setData(File file) throws IOException {",
                  "public void setData(String name) throws IOException { File file = new "
                  "File(ray.RayTracer.testFolderPath + name);");
  program.replace("ray/Parser.java", "} else if (wanted == File.class) {",
                  "} else if (wanted == String.class) { made = text; } else if (wanted == File.class) {");
  program.compile();
  expect_right_answers(program.ask(java_questions(program)), kTolerance);
}

TEST(JavaYears, GroupsThatHideTheirMembersAreFlattened) {
  JavaProgram program;
  program.replace("ray/surface/Group.java", "private final List<Surface> objs = new ArrayList<>();", R"(
    private static final class Hidden implements Iterable<Surface> {
        private final java.util.Map<Integer, Surface> all = new java.util.TreeMap<>();
        void add(Surface surface) { all.put(all.size(), surface); }
        public java.util.Iterator<Surface> iterator() { return all.values().iterator(); }
    }
    private final Hidden objs = new Hidden();)");
  program.compile();
  std::vector<json> questions = java_questions(program);
  program.write("grouped.xml",
                "<scene><image>1 1</image><surface type='Group'><surface type='Sphere'/>"
                "<surface type='Mesh'><data>square.msh</data></surface></surface></scene>");
  questions.push_back({{"ask", "load"}, {"scene", program.path("grouped.xml")}});
  questions.push_back({{"ask", "surfaces"}});
  std::vector<json> answers = program.ask(questions);
  EXPECT_EQ(answers[0]["surfaces"], "flat");
  EXPECT_EQ(answers[10]["surfaces"],
            json({{{"type", "Sphere"}, {"numbers", {0.0, 0.0, 0.0, 1.0}}}, {{"type", "Mesh"}, {"numbers", {2}}}}));
  answers.resize(9);
  expect_right_answers(answers, kTolerance);
}

TEST(JavaYears, AnotherProgramSaysWhatItLacks) {
  JavaProgram program;
  program.replace("ray/Parser.java", "public Object parse(String file, Class<?> type)",
                  "public Object read(String file, Class<?> type)");
  program.compile();
  EXPECT_EQ(program.ask(java_questions(program))[1]["unsupported"], "ray.Parser has no member parse(String, Class)");
  const std::vector<json> none = program.ask({{{"ask", "load"}, {"scene", "x"}}}, "-Dplumb.package=nowhere");
  EXPECT_THAT(none[1]["error"].get<std::string>(), HasSubstr("no framework on the class path"));
}

}  // namespace
}  // namespace plumb
