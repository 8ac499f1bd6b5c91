// The adapter on the framework of examples/java-framework, and on its planted faults.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "tools/adapters/java_scene.h"

namespace plumb {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

// Numbers up to 50 after some twenty operations: 50 * 20 * 2^-53 < 2e-13.
constexpr double kTolerance = 1e-12;

TEST(JavaProbe, AnswersForTheFrameworkOfTheExamples) {
  JavaProgram program;
  program.compile();
  const std::vector<json> answers = program.ask(java_questions(program));
  expect_right_answers(answers, kTolerance);

  EXPECT_EQ(answers[0]["plumb"], 1);
  EXPECT_EQ(answers[0]["name"], "java-ray");
  EXPECT_EQ(answers[0]["precision"], "double");
  EXPECT_EQ(answers[0]["surfaces"], "tree");
  EXPECT_EQ(answers[0]["shapes"], json({"mesh", "sphere", "box", "cylinder"}));
  EXPECT_EQ(answers[0]["can"], json({"normal", "any", "all", "bounds", "matrices", "average_position"}));
  const json expected = {{{"type", "Sphere"}, {"path", "0"}, {"numbers", {0.0, 0.0, 0.0, 0.1}}},
                         {{"type", "Box"}, {"path", "1/0"}, {"numbers", {0.0, 0.0, 0.0, 1.0, 2.0, 3.0}}},
                         {{"type", "Cylinder"}, {"path", "1/1/0"}, {"numbers", {5.0, 5.0, 5.0, 0.5, 2.0}}},
                         {{"type", "Box"}, {"path", "2/0"}, {"numbers", {-1.0, -2.0, -3.0, 1.0, 2.0, 3.0}}},
                         {{"type", "Mesh"}, {"path", "3"}, {"numbers", {2}}},
                         {{"type", "Sphere"}, {"path", "4/0"}, {"numbers", {0.0, 0.0, 0.0, 1.0}}}};
  EXPECT_EQ(answers[2]["surfaces"], expected) << answers[2].dump(1);
  // What the framework prints while it loads a mesh is log.
  EXPECT_THAT(program.log(), HasSubstr("Loading square.msh"));
}

TEST(JavaProbe, ASurfaceReferredToTwiceStandsInBothPlaces) {
  JavaProgram program;
  program.compile();
  program.write("twice.xml", R"(<scene><image>4 4</image>
    <surface type="Group"><translate>5 0 0</translate><surface name="ball" type="Sphere"/></surface>
    <surface type="Group"><translate>-5 0 0</translate><surface ref="ball"/></surface></scene>)");
  const std::vector<json> answers =
      program.ask({{{"ask", "load"}, {"scene", program.path("twice.xml")}}, {{"ask", "bounds"}}});
  ASSERT_EQ(answers[2]["bounds"].size(), 2u) << answers[2];
  EXPECT_EQ(answers[2]["bounds"][0], json({4.0, -1.0, -1.0, 6.0, 1.0, 1.0}));
  EXPECT_EQ(answers[2]["bounds"][1], json({-6.0, -1.0, -1.0, -4.0, 1.0, 1.0}));
}

TEST(JavaProbe, NothingThatGoesWrongEndsIt) {
  JavaProgram program;
  program.compile();
  program.write("mesh.xml", "<scene><surface type=\"Mesh\"><data>missing.msh</data></surface></scene>");
  program.write("ball.xml", "<scene><surface type=\"Sphere\"/></scene>");
  const std::vector<json> answers = program.ask({
      {{"ask", "bounds"}},
      {{"ask", "load"}, {"scene", "/no/such/scene.xml"}},
      {{"ask", "load"}, {"scene", program.path("mesh.xml")}},
      {{"ask", "bounds"}},
      {{"ask", "load"}, {"scene", program.path("ball.xml")}},
      {{"ask", "fresnel"}, {"queries", {{1, 1, 1.5}}}},
      {{"ask", "trace"}, {"pixels", {{0, 0}}}},
      {{"ask", "bounds"}},
  });
  EXPECT_EQ(answers[1]["error"], "no scene has been loaded");
  EXPECT_THAT(answers[2]["error"].get<std::string>(), HasSubstr("/no/such/scene.xml"));
  EXPECT_THAT(answers[3]["error"].get<std::string>(), HasSubstr("missing.msh"));
  EXPECT_EQ(answers[4]["error"], "no scene has been loaded") << "a refused scene leaves none behind";
  EXPECT_EQ(answers[6]["unsupported"], "the Java adapter does not answer 'fresnel'");
  EXPECT_EQ(answers[7]["unsupported"], "the Java adapter does not answer 'trace'");
  EXPECT_EQ(answers[8]["bounds"][0], json({-1.0, -1.0, -1.0, 1.0, 1.0, 1.0}));
}

TEST(JavaProbe, AnExceptionIsAnErrorAndNamesItsPlace) {
  JavaProgram program;
  program.replace("ray/surface/Box.java", "setBox(bounds.min(), bounds.max());", "");
  program.replace("ray/surface/Sphere.java", "double b = f.dot(d);",
                  "double b = f.dot(d); if (b > 0) throw new IllegalStateException(\"a \\\"bad\\\" ray\");");
  program.compile();
  program.write("box.xml", "<scene><image>4 4</image><surface type=\"Box\"/></scene>");
  program.write("ball.xml", "<scene><image>4 4</image><surface type=\"Sphere\"/></scene>");
  const std::vector<json> answers = program.ask({
      {{"ask", "load"}, {"scene", program.path("box.xml")}},
      {{"ask", "load"}, {"scene", program.path("ball.xml")}},
      {{"ask", "closest"}, {"rays", {{0, 0, 0.5, 0, 0, 1, 0, "inf"}}}},
      {{"ask", "closest"}, {"rays", {{0, 0, 5, 0, 0, -1, 0, "inf"}}}},
  });
  EXPECT_THAT(answers[1]["error"].get<std::string>(), HasSubstr("NullPointerException"));
  EXPECT_THAT(answers[3]["error"].get<std::string>(),
              testing::AllOf(HasSubstr("a \"bad\" ray"), HasSubstr("ray.surface.Sphere.intersect(Sphere.java:")));
  EXPECT_EQ(answers[4]["hits"][0]["t"], 4.0);
}

TEST(JavaProbe, NamesTheMemberThatIsMissing) {
  JavaProgram program;
  program.replace_everywhere("tMatInv", "toObject");
  program.compile();
  const std::vector<json> answers = program.ask(java_questions(program));
  EXPECT_EQ(answers[4]["unsupported"], "ray.surface.Sphere has no member tMatInv");
  EXPECT_THAT(answers[0]["can"].dump(), Not(HasSubstr("matrices")));
  EXPECT_EQ(answers[6]["hits"][1]["t"], 14.0) << "the rest is answered";
}

TEST(JavaProbe, AChattyFrameworkIsHeardAsLogAlone) {
  JavaProgram program;
  program.replace(
      "ray/surface/Sphere.java", "protected double radius = 1;",
      "protected double radius = 1; static { System.out.println(\"{\\\"plumb\\\": \\\"Sphere is here\\\"}\"); }");
  program.replace("ray/surface/Sphere.java", "Ray object = untransformRay(ray);",
                  "Ray object = untransformRay(ray); System.out.print(\"{\\\"plumb\\\": half a line\"); "
                  "System.err.println(\"hit?\");");
  program.replace("ray/Scene.java", "protected Image image;",
                  "protected Image image; static { System.out.print(\"no line end\"); }");
  program.compile();
  expect_right_answers(program.ask(java_questions(program)), kTolerance);
  EXPECT_THAT(program.log(), HasSubstr("Sphere is here"));
  EXPECT_THAT(program.log(), HasSubstr("half a line"));
}

TEST(JavaProbe, WhatReflectionCannotSeeIsSaidOnTheCommandLine) {
  JavaProgram program;
  program.compile();
  const json greeting = program.ask({}, "-Dplumb.edges=watertight -Dplumb.name=mine")[0];
  EXPECT_EQ(greeting["edges"], "watertight");
  EXPECT_EQ(greeting["name"], "mine");
  EXPECT_FALSE(greeting.contains("range"));
}

// ---- The planted faults: each changes what it should, and the tests above hold without it.

TEST(JavaFaults, EachIsAFewLinesOfOneFile) {
  const std::filesystem::path examples = std::string(PLUMB_SOURCE_DIR) + "/examples";
  const auto lines = [](const std::filesystem::path& file) {
    std::multiset<std::string> found;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) found.insert(line);
    return found;
  };
  int faults = 0;
  for (const auto& folder : std::filesystem::directory_iterator(examples / "java-framework-faulty")) {
    if (!folder.is_directory()) continue;
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      ++files;
      const auto wrong = lines(entry.path());
      const auto right = lines(examples / "java-framework" / entry.path().lexically_relative(folder));
      std::vector<std::string> changed;
      std::ranges::set_symmetric_difference(wrong, right, std::back_inserter(changed));
      EXPECT_GE(changed.size(), 1u) << entry.path();
      EXPECT_LE(changed.size(), 12u) << entry.path() << " has drifted from the framework";
    }
    EXPECT_EQ(files, 1) << folder.path();
    ++faults;
  }
  EXPECT_EQ(faults, 5);
}

std::vector<json> answers_of_fault(const std::string& name) {
  JavaProgram program;
  program.overlay(std::string(PLUMB_SOURCE_DIR) + "/examples/java-framework-faulty/" + name);
  program.compile();
  return program.ask(java_questions(program));
}

TEST(JavaFaults, RotationOrderShowsInTheMatrix) {
  const std::vector<json> answers = answers_of_fault("rotation-order");
  // Rx Ry Rz: (2x, y, z) goes to (-y, 2x, z), then to (-y, -z, 2x).
  expect_near(answers[4]["matrices"][1]["world"], {0, -1, 0, 10, 0, 0, -1, 0, 2, 0, 0, 0}, kTolerance);
}

TEST(JavaFaults, ABoxMissesACorner) {
  const std::vector<json> answers = answers_of_fault("box-misses-corner");
  EXPECT_FALSE(holds_corners(answers[3]["bounds"][3], answers[4]["matrices"][3]["world"], {1, 2, 3}, 0.01));
}

TEST(JavaFaults, ABoxIsNotTransformed) {
  const std::vector<json> answers = answers_of_fault("box-not-transformed");
  expect_near(answers[3]["bounds"][5], {-1, -1, -1, 1, 1, 1}, kTolerance);
}

TEST(JavaFaults, ANormalGoesByTheMatrix) {
  const std::vector<json> answers = answers_of_fault("normal-by-matrix");
  expect_near(answers[6]["hits"][7]["n"], {2 / std::sqrt(5.0), 0, 1 / std::sqrt(5.0)}, kTolerance);
}

TEST(JavaFaults, TIsOfTheNormalisedDirection) {
  const std::vector<json> answers = answers_of_fault("t-normalised");
  EXPECT_NEAR(answers[6]["hits"][1]["t"].get<double>(), 7, kTolerance) << "in world units, not in lengths of 0.5";
}

}  // namespace
}  // namespace plumb
