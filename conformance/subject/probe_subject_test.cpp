#include "conformance/subject/probe_subject.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cerrno>
#include <fstream>
#include <functional>
#include <string>

#include "conformance/sandbox/run_process.h"

namespace plumb {
namespace {

using testing::HasSubstr;

/// What came of asking: `fail (protocol)`, `unsupported`, or nothing.
std::string outcome_of(const std::function<void()>& ask, std::string* sentence = nullptr) {
  try {
    ask();
    return "";
  } catch (const SubjectFailure& failure) {
    if (sentence) *sentence = failure.what();
    return std::string(to_string(failure.verdict())) + " (" + failure.cause() + ")";
  } catch (const UnsupportedBySubject& unsupported) {
    if (sentence) *sentence = unsupported.what();
    return "unsupported";
  }
}

const Ray kRay{{0, 0, 5}, {0, 0, -1}};

SubjectScene one_sphere() {
  SubjectSurface sphere;
  sphere.shape.kind = ShapeKind::sphere;
  return {sphere};
}

class ProbeSubjectTest : public testing::Test {
 protected:
  static ProbeCommand scripted(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), MISBEHAVING_PROBE);
    return {.arguments = std::move(arguments), .folder = "/", .environment = {}};
  }
  /// What becomes of one ray. Before and afterwards the subject answers two.
  static std::string fault_of(const std::string& mode, std::string* sentence = nullptr, double seconds = 30) {
    ProbeCommand command = scripted({mode});
    command.limits.wall_seconds = seconds;
    ProbeSubject subject(command);
    subject.load(one_sphere());
    expect_sound(subject);
    const std::string outcome = outcome_of([&] { subject.closest({&kRay, 1}); }, sentence);
    subject.load(one_sphere());
    expect_sound(subject);
    return outcome;
  }
  static void expect_sound(ProbeSubject& subject) {
    const std::vector<SubjectHit> hits = subject.closest(std::vector<Ray>(2, kRay));
    ASSERT_EQ(hits.size(), 2u);
    for (const SubjectHit& hit : hits) {
      EXPECT_EQ(hit.surface, 0u);
      EXPECT_EQ(hit.t, 4);
      EXPECT_FALSE(hit.has_weights);
    }
  }
  /// What becomes of loading a scene with this list of surfaces.
  static std::string outcome_of_list(const SubjectScene& scene, const std::string& list, std::string* sentence) {
    ProbeSubject subject(scripted({"", "surfaces=\"surfaces\":" + list}));
    return outcome_of([&] { subject.load(scene); }, sentence);
  }
  void TearDown() override {
    errno = 0;
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG | __WALL), -1) << "a child is left";
    EXPECT_EQ(errno, ECHILD);
  }
};

TEST_F(ProbeSubjectTest, TakesWrongAnswersAsProtocolFaults) {
  for (const char* mode :
       {"garbage",        "log-on-line", "wrong-id",       "no-id",        "no-version", "list",   "no-key",
        "wrong-type",     "short",       "long",           "text-hit",     "no-t",       "text-t", "index",
        "negative-index", "huge-index",  "fraction-index", "short-normal", "half-line",  "exit-0", "deep"})
    EXPECT_EQ(fault_of(mode), "fail (protocol)") << mode;
}

TEST_F(ProbeSubjectTest, TakesNoNumberThatIsNone) {
  for (const char* mode : {"nan", "inf", "bare-nan", "bare-inf", "too-large", "nan-normal"})
    EXPECT_EQ(fault_of(mode), "fail (not_finite)") << mode;
}

TEST_F(ProbeSubjectTest, TellsHowTheProgramEnded) {
  std::string sentence;
  EXPECT_EQ(fault_of("crash", &sentence), "crash (signal)");
  EXPECT_EQ(sentence, "a signal ended it, number 11, at closest");
  EXPECT_EQ(fault_of("half-line-crash"), "crash (signal)");
  EXPECT_EQ(fault_of("exit-3", &sentence), "crash (exit_status)");
  EXPECT_EQ(sentence, "it ended with exit status 3 at closest");
}

TEST_F(ProbeSubjectTest, EndsWhatDoesNotAnswer) {
  EXPECT_EQ(fault_of("silent", nullptr, 0.2), "timeout (wall_time)");
  EXPECT_EQ(fault_of("flood", nullptr, 0.2), "timeout (wall_time)");
  EXPECT_EQ(fault_of("endless"), "fail (protocol)");
}

TEST_F(ProbeSubjectTest, HoldsItToItsProcessorTime) {
  ProbeCommand command = scripted({"burn"});
  command.limits.cpu_seconds = 0.2;
  ProbeSubject subject(command);
  subject.load(one_sphere());
  EXPECT_EQ(outcome_of([&] { subject.closest({&kRay, 1}); }), "timeout (cpu_time)");
}

TEST_F(ProbeSubjectTest, PassesOnWhatTheProgramSays) {
  std::string sentence;
  EXPECT_EQ(fault_of("error", &sentence), "fail (error)");
  EXPECT_EQ(sentence, "to closest it said: no idea");
  EXPECT_EQ(fault_of("unsupported", &sentence), "unsupported");
  EXPECT_EQ(sentence, "closest: no rays here");
}

TEST_F(ProbeSubjectTest, FindsAnAnswerThatNobodyAskedFor) {
  ProbeSubject subject(scripted({"two-lines"}));
  subject.load(one_sphere());
  EXPECT_EQ(subject.closest({&kRay, 1}).size(), 1u);
  EXPECT_EQ(outcome_of([&] { subject.closest({&kRay, 1}); }), "fail (protocol)");
}

TEST_F(ProbeSubjectTest, JudgesAChattyProgramLikeASilentOne) {
  EXPECT_EQ(fault_of("chatty"), "");
  EXPECT_EQ(fault_of("standard"), "");
}

TEST_F(ProbeSubjectTest, KeepsTheLogOfAFailure) {
  ProbeSubject subject(scripted({"standard"}));
  subject.load(one_sphere());
  EXPECT_EQ(outcome_of([&] { subject.bounds(); }), "fail (protocol)") << "its answer has no bounds";
  EXPECT_THAT(subject.failure_log(), HasSubstr("a tracer, version 7\n{\"json\": \"but no answer\"}\nasked for load\n"));
}

TEST_F(ProbeSubjectTest, NeedsAGreeting) {
  const auto fault_of_greeting = [&](const std::string& mode, const std::string& greeting, std::string* sentence) {
    ProbeCommand command = scripted({mode, "greeting=" + greeting});
    command.limits.wall_seconds = mode.empty() ? 30 : 0.3;
    return outcome_of([&] { ProbeSubject subject(command); }, sentence);
  };
  std::string sentence;
  EXPECT_EQ(fault_of_greeting("no-greeting", "", &sentence), "timeout (wall_time)");
  EXPECT_EQ(fault_of_greeting("half-greeting", "", &sentence), "fail (protocol)");
  EXPECT_EQ(fault_of_greeting("", "hello", &sentence), "fail (protocol)");
  EXPECT_EQ(fault_of_greeting("", "{\"plumb\":2}", &sentence), "fail (protocol)");
  EXPECT_EQ(sentence, "the greeting is of version 2 of the protocol, expected 1");
  EXPECT_EQ(fault_of_greeting("", "{\"plumb\":1,\"edges\":\"sharp\"}", &sentence), "fail (protocol)");
  EXPECT_EQ(
      sentence,
      "the greeting's \"edges\" is \"sharp\", expected one of \"closed\", \"top_left\", \"watertight\", \"none\"");
  EXPECT_EQ(fault_of_greeting("", "{\"plumb\":1,\"can\":\"all\"}", &sentence), "fail (protocol)");
  EXPECT_EQ(fault_of_greeting("", "{\"plumb\":1,\"shapes\":[1]}", &sentence), "fail (protocol)");

  const ProbeCommand none{.arguments = {"./no-such-program"}, .folder = "/", .environment = {}};
  EXPECT_EQ(outcome_of([&] { ProbeSubject subject(none); }, &sentence), "fail (cannot_start)");
  EXPECT_EQ(sentence, "cannot run ./no-such-program: No such file or directory");
}

TEST_F(ProbeSubjectTest, ReadsTheContract) {
  const ProbeSubject plain(scripted({"", "greeting={\"plumb\":1,\"name\":\"a b/c\",\"news\":[]}"}));
  EXPECT_EQ(plain.name(), "a-b-c");
  const Contract& p = plain.contract();
  EXPECT_EQ(to_string(p),
            "double in, double t, edges closed, range closed, from inside hits the exit, meshes in float");
  EXPECT_EQ(p.shapes, unsigned(PLUMB_MESHES | PLUMB_SPHERES | PLUMB_BOXES | PLUMB_CYLINDERS));
  EXPECT_EQ(p.capabilities, unsigned(PLUMB_TRANSFORMS));
  EXPECT_FALSE(p.matrices || p.fresnel || p.refract || p.frame || p.average_position || plain.can_trace());
}

TEST_F(ProbeSubjectTest, ReadsAContractOfMoreWords) {
  ProbeSubject subject(scripted(
      {"",
       R"(greeting={"plumb":1,"precision":"float","float_meshes":false,"edges":"top_left","culling":"back",)"
       R"("range":"open","inside":"miss","shapes":["cone"],"can":["any","all","bounds","trace","frame","more"]})"}));
  const Contract& c = subject.contract();
  EXPECT_EQ(to_string(c), "float in, float t, edges top-left, range open, from inside misses, culls back faces");
  EXPECT_EQ(c.shapes, unsigned(PLUMB_CONES));
  EXPECT_EQ(c.capabilities, unsigned(PLUMB_TRANSFORMS | PLUMB_ANY_HIT | PLUMB_ALL_HITS | PLUMB_BOUNDS));
  EXPECT_TRUE(c.frame && subject.can_trace());
  EXPECT_EQ(outcome_of([&] { subject.load(one_sphere()); }), "unsupported");
  EXPECT_EQ(outcome_of([&] { subject.fresnel(1, 1, 1.5); }), "unsupported");
  EXPECT_EQ(outcome_of([&] { subject.matrices(); }), "unsupported");
}

TEST_F(ProbeSubjectTest, RefusesAMatrixWithoutGroups) {
  SubjectScene scene = one_sphere();
  scene[0].world_from_object = scaling({2, 2, 2});
  ProbeSubject subject(scripted({""}));
  EXPECT_EQ(outcome_of([&] { subject.load(scene); }), "unsupported");
  EXPECT_THROW(subject.closest({&kRay, 1}), std::logic_error) << "nothing is loaded";
}

/// Two spheres in groups, a mesh of two triangles used twice, and a box.
SubjectScene mixed_scene() {
  const TriangleMesh square{{{0, 0, 0}, {1, 0, 0}, {0.1, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}, {}, {}};
  const auto mesh = std::make_shared<const TriangleMesh>(square);
  SubjectScene scene(5);
  for (const std::size_t i : {0, 3}) scene[i].shape.kind = ShapeKind::sphere;
  for (const std::size_t i : {1, 4}) {
    scene[i].shape.kind = ShapeKind::mesh;
    scene[i].shape.mesh = mesh;
  }
  scene[2].shape.kind = ShapeKind::box;
  scene[2].shape.max = {1, 0.1, 1};
  scene[3].groups = {{{TransformStep::Kind::translate, {1, 2, 3}}}, {}};
  return scene;
}

constexpr const char* kSphere = R"({"type":"Sphere","numbers":[0,0,0,1]})";
constexpr const char* kBox = R"({"type":"Box","numbers":[0,0,0,1,0.1,1]})";
constexpr const char* kMesh = R"({"type":"Mesh","numbers":[2]})";
/// 0.1 in single precision, as meshes are.
constexpr const char* kLower = R"({"type":"Triangle","numbers":[0,0,0, 1,0,0, 0.10000000149011612,1,0]})";
constexpr const char* kUpper = R"({"type":"Triangle","numbers":[1,0,0, 1,1,0, 0.10000000149011612,1,0]})";

std::string list_of_surfaces(const std::vector<std::string>& surfaces) {
  std::string list;
  for (const std::string& surface : surfaces) list += (list.empty() ? "[" : ",") + surface;
  return list + "]";
}

TEST_F(ProbeSubjectTest, MatchesFlattenedSurfacesInAnyOrder) {
  const std::string list = list_of_surfaces({kUpper, kBox, kLower, kSphere, kSphere, kUpper, kLower});
  // The n-th listed has the box [n, n + 1]; rays hit all of them, by turns.
  std::string boxes, hits;
  for (int n = 0; n < 7; ++n) {
    boxes += (n ? "," : "") + std::string("[") + std::to_string(n) + ",0,0," + std::to_string(n + 1) + ",1,1]";
    hits += (n ? "," : "") + std::string("{\"s\":") + std::to_string(n) + ",\"t\":1,\"p\":7}";
  }
  ProbeSubject subject(scripted(
      {"", "surfaces=\"surfaces\":" + list, "bounds=\"bounds\":[" + boxes + "]", "closest=\"hits\":[" + hits + "]"}));
  subject.load(mixed_scene());
  const std::vector<SubjectHit> found = subject.closest(std::vector<Ray>(7, kRay));
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> expected{{1, 1}, {2, 0}, {1, 0}, {0, 0},
                                                                      {3, 0}, {4, 1}, {4, 0}};
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(found[i].surface, expected[i].first) << i;
    EXPECT_EQ(found[i].primitive, expected[i].second) << i;
  }
  const std::vector<Bounds3> bounds = subject.bounds();
  ASSERT_EQ(bounds.size(), 5u);
  EXPECT_EQ(bounds[0], (Bounds3{{3, 0, 0}, {4, 1, 1}}));
  EXPECT_EQ(bounds[1], (Bounds3{{0, 0, 0}, {3, 1, 1}})) << "around both of its triangles";
  EXPECT_EQ(bounds[4], (Bounds3{{5, 0, 0}, {7, 1, 1}}));
}

TEST_F(ProbeSubjectTest, MatchesMeshesAsTheyAreListed) {
  std::string sentence;
  const auto outcome = [&](const std::vector<std::string>& surfaces) {
    return outcome_of_list(mixed_scene(), list_of_surfaces(surfaces), &sentence);
  };
  EXPECT_EQ(outcome({kSphere, kMesh, kBox, kSphere, kMesh}), "");
  EXPECT_EQ(outcome({kSphere, kMesh, kBox, kSphere, kLower, kUpper}), "");
  const std::string first = R"({"type":"Triangle","numbers":[0]})";
  const std::string second = R"({"type":"Triangle","numbers":[1]})";
  EXPECT_EQ(outcome({kSphere, kBox, kSphere, first, second, first, second}), "");

  EXPECT_EQ(outcome({kSphere, kMesh, kBox, kMesh}), "fail (surfaces)");
  EXPECT_EQ(sentence, "its surfaces are not those of the scene: it lacks 1, such as Sphere 0 0 0 1");
  EXPECT_EQ(outcome({kSphere, kMesh, kBox, kSphere, kMesh, kLower}), "fail (surfaces)");
  EXPECT_EQ(outcome({kSphere, kMesh, kBox, kSphere, kLower}), "fail (surfaces)");
  EXPECT_EQ(outcome({kSphere, kMesh, kBox, kSphere, kLower, kLower}), "fail (surfaces)");
  EXPECT_EQ(outcome({kSphere, kMesh, R"({"type":"Box","numbers":[0,0,0,1,0.2,1]})", kSphere, kMesh}),
            "fail (surfaces)");
  EXPECT_EQ(sentence,
            "its surfaces are not those of the scene: it lacks 1, such as Box 0 0 0 1 0.1 1; 1 are not in the scene, "
            "such as Box 0 0 0 1 0.2 1");
  EXPECT_EQ(outcome({kSphere, R"({"type":"Torus","numbers":[]})"}), "fail (protocol)");
  EXPECT_EQ(outcome({kSphere, R"({"type":"Sphere"})"}), "fail (protocol)");
  EXPECT_EQ(outcome({R"({"type":"Sphere","path":7,"numbers":[]})"}), "fail (protocol)");
}

TEST_F(ProbeSubjectTest, MatchesByPath) {
  std::string sentence;
  const auto listed = [](const char* surface, const char* path) {
    return std::string(surface).insert(1, "\"path\":\"" + std::string(path) + "\",");
  };
  const auto outcome = [&](const std::vector<std::string>& surfaces) {
    return outcome_of_list(mixed_scene(), list_of_surfaces(surfaces), &sentence);
  };
  const std::string box = listed(kBox, "2");
  const std::string sphere = listed(kSphere, "3/0/0");
  const std::string mesh = listed(kMesh, "1");
  EXPECT_EQ(outcome({sphere, box, listed(kSphere, "0"), mesh, listed(kMesh, "4")}), "");
  EXPECT_EQ(outcome({sphere, box, listed(kSphere, "0"), mesh, listed(kUpper, "4"), listed(kLower, "4")}), "");
  EXPECT_EQ(outcome({sphere, box, listed(kSphere, "0/0"), mesh, listed(kMesh, "4")}), "fail (surfaces)");
  EXPECT_EQ(sentence,
            "its surfaces are not those of the scene: it lacks 1, such as Sphere 0 0 0 1 at 0; 1 are not in the scene, "
            "such as Sphere 0 0 0 1 at 0/0");
}

TEST_F(ProbeSubjectTest, CombinesTheMatricesOfTriangles) {
  const std::string unit =
      R"({"world":[1,0,0,0,0,1,0,0,0,0,1,0],"inverse":[1,0,0,0,0,1,0,0,0,0,1,0],"inverse_transpose":[1,0,0,0,1,0,0,0,1]})";
  const std::string other =
      R"({"world":[1,0,0,2,0,1,0,0,0,0,1,0],"inverse":[1,0,0,0,0,1,0,0,0,0,1,0],"inverse_transpose":[1,0,0,0,1,0,0,0,1]})";
  SubjectScene scene = mixed_scene();
  scene.resize(2);
  const std::string surfaces = "surfaces=\"surfaces\":" + list_of_surfaces({kLower, kUpper, kSphere});
  const std::string places = "average_positions=\"average_positions\":[[0,1,2],[2,1,0],[7,8,9]]";
  const auto with = [&](const std::string& second) {
    return scripted({"", surfaces, places, "matrices=\"matrices\":[" + unit + "," + second + "," + unit + "]"});
  };
  {
    ProbeSubject subject(with(unit));
    subject.load(scene);
    EXPECT_EQ(subject.matrices().size(), 2u);
    EXPECT_EQ(subject.matrices()[1].world_from_object, identity_matrix());
    EXPECT_EQ(subject.average_positions(), (std::vector<Point3>{{7, 8, 9}, {1, 1, 1}}));
  }
  ProbeSubject subject(with(other));
  subject.load(scene);
  EXPECT_EQ(outcome_of([&] { subject.matrices(); }), "fail (surfaces)");
}

}  // namespace
}  // namespace plumb
