#include "scenes/read_scene.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "scenes/scene_kind.h"

namespace plumb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::array kBallParameters{
    Parameter{.name = "shader",
              .type = ValueType::object,
              .meaning = "",
              .presence = Presence::optional,
              .role = Role::shader},
    Parameter{.name = "middle",
              .type = ValueType::point,
              .meaning = "",
              .presence = Presence::defaulted,
              .default_text = "1 2 3"},
    Parameter{.name = "size",
              .type = ValueType::number,
              .meaning = "",
              .presence = Presence::defaulted,
              .default_text = "4.5"},
    Parameter{
        .name = "width", .type = ValueType::number, .meaning = "", .presence = Presence::optional, .alias_of = "size"},
    Parameter{.name = "count",
              .type = ValueType::integer,
              .meaning = "",
              .presence = Presence::defaulted,
              .default_text = "7"},
    Parameter{.name = "picture", .type = ValueType::file, .meaning = "", .presence = Presence::optional},
};
constexpr std::array kPaintParameters{
    Parameter{.name = "tint", .type = ValueType::color, .meaning = "", .presence = Presence::required},
    Parameter{.name = "under",
              .type = ValueType::object,
              .meaning = "",
              .presence = Presence::optional,
              .role = Role::shader},
};
constexpr Kind kBall{Role::surface, "Ball", "", kBallParameters};
constexpr Kind kPaint{Role::shader, "Paint", "", kPaintParameters};
constexpr Kind kLamp{Role::light, "Lamp", "", {}};

const KindTable& small_table() {
  static const KindTable table{{&kBall, &kPaint, &kLamp}, {&kLamp}};
  return table;
}

SceneDescription read_text(const std::string& text) {
  struct Folder {
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path path =
        std::filesystem::path(::testing::TempDir()) / ("plumb-scenes-" + std::to_string(getpid()));
  };
  static const Folder of_this_process;
  const std::filesystem::path& folder = of_this_process.path;
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "s.xml", std::ios::binary) << text;
  return read_scene(folder / "s.xml", small_table());
}

/// A scene of 2x3 pixels whose elements begin at line 2, column 1.
SceneDescription read_elements(const std::string& elements) {
  return read_text("<scene><image>2 3</image>\n" + elements + "</scene>");
}

ObjectPointer surface(const SceneDescription& scene, std::size_t index = 0) {
  return scene.scene->objects("surface").at(index);
}

/// `line:column: text` of the error, or nothing.
std::string refusal(const std::string& elements) {
  try {
    read_elements(elements);
  } catch (const InputError& error) {
    return std::string(error.what()).substr(error.where().file.size() + 1);
  }
  return "";
}

TEST(ReadScene, TagsMatchWithoutRegardToCase) {
  const auto scene = read_text("<SCENE><Image>2 3</Image><SURFACE type='Ball'><SiZe>9</SiZe></SURFACE></SCENE>");
  EXPECT_EQ(scene.scene->size("image"), (Size2{2, 3}));
  EXPECT_EQ(surface(scene)->number("size"), 9);
}

TEST(ReadScene, TypeIsTakenWithAndWithoutPackage) {
  EXPECT_EQ(surface(read_elements("<surface type='Ball'/>"))->kind, &kBall);
  EXPECT_EQ(surface(read_elements("<surface type='ray.surface.Ball'/>"))->kind, &kBall);
  EXPECT_THAT(refusal("<surface type='ball'/>"), HasSubstr("did you mean 'Ball'?"))
      << "kinds are class names: case counts";
}

TEST(ReadScene, UntypedElementsTakeTheirRolesDefaultKind) {
  EXPECT_EQ(read_elements("<light/>").scene->objects("light").at(0)->kind, &kLamp);
  EXPECT_THAT(refusal("<surface/>"),
              HasSubstr("2:1: <surface> has no type, expected type=\"...\" with one of Ball, Group"));
}

TEST(ReadScene, ParametersThatAreNotGivenHaveTheirDefaults) {
  const auto scene = read_elements("<surface type='Ball'/>");
  const ObjectPointer ball = surface(scene);
  EXPECT_EQ(ball->point("middle"), (Point3{1, 2, 3}));
  EXPECT_EQ(ball->number("size"), 4.5);
  EXPECT_EQ(ball->integer("count"), 7);
  EXPECT_EQ(ball->object("shader"), nullptr);
  EXPECT_FALSE(ball->has("size"));
  EXPECT_THROW(ball->file_name("picture"), std::logic_error);
  EXPECT_THROW(ball->number("weight"), std::logic_error);
}

TEST(ReadScene, AnAliasIsStoredUnderItsParameter) {
  const auto scene = read_elements("<surface type='Ball'><width>2</width></surface>");
  EXPECT_EQ(surface(scene)->number("size"), 2);
  EXPECT_TRUE(surface(scene)->has("size"));
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(ReadScene, TheLastOfSeveralWinsWithAWarning) {
  const auto scene =
      read_elements("<surface type='Ball'>\n <size>1</size>\n <Width>2</Width>\n <SIZE>3</SIZE></surface>");
  EXPECT_EQ(surface(scene)->number("size"), 3);
  ASSERT_EQ(scene.warnings.size(), 2u);
  EXPECT_THAT(scene.warnings[0],
              HasSubstr("s.xml:4:2: warning: <Width> was given before at line 3; the last one counts"));
  EXPECT_THAT(scene.warnings[1], HasSubstr("s.xml:5:2: warning: <SIZE> was given before at line 4"));
  EXPECT_EQ(surface(scene)->where("size").line, 5);
}

TEST(ReadScene, RepeatableElementsKeepFileOrderWithoutWarning) {
  const auto scene = read_elements(
      "<surface type='Group'><translate>1 0 0</translate><surface type='Ball'/><scale>2 2 2</scale>"
      "<translate>3 0 0</translate></surface>");
  std::vector<std::string> names;
  for (const Property& property : surface(scene)->properties) names.emplace_back(property.parameter->name);
  EXPECT_THAT(names, ElementsAre("translate", "surface", "scale", "translate"));
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(ReadScene, ARefIsTheSameObject) {
  const auto scene = read_elements(
      "<shader type='Paint' name='p'><tint>1 0 0</tint></shader>"
      "<surface type='Ball' name='b'><shader ref='p'/></surface><surface ref='b'/>");
  EXPECT_EQ(surface(scene, 0), surface(scene, 1));
  EXPECT_EQ(surface(scene)->object("shader"), scene.scene->objects("shader").at(0));
  EXPECT_EQ(surface(scene)->name, "b");
}

TEST(ReadScene, ValuesHaveNamesAndRefsToo) {
  const auto scene = read_elements(
      "<surface type='Ball'><size name='s'>8</size><middle name='m'>4 5 6</middle></surface>"
      "<surface type='Ball'><width ref='s'/><middle ref='m'/></surface>");
  EXPECT_EQ(surface(scene, 1)->number("size"), 8);
  EXPECT_EQ(surface(scene, 1)->point("middle"), (Point3{4, 5, 6}));
}

TEST(ReadScene, ARefMayCarryANameOfItsOwn) {
  const auto scene = read_elements("<surface type='Ball' name='a'/><surface ref='a' name='b'/><surface ref='b'/>");
  EXPECT_EQ(surface(scene, 2), surface(scene, 0));
}

TEST(ReadScene, ARefMustFollowItsName) {
  EXPECT_THAT(refusal("<surface ref='ball'/>\n<surface type='Ball' name='ball'/>"),
              HasSubstr("2:1: the name 'ball' is not complete"));
  EXPECT_THAT(refusal("<surface type='Group' name='g'>\n <surface ref='g'/></surface>"),
              HasSubstr("3:2: the name 'g' is not complete"))
      << "so no element can hold itself";
}

TEST(ReadScene, ARefOfAnotherCategoryIsRefused) {
  const std::string named =
      "<shader type='Paint' name='p'><tint name='t'>1 0 0</tint></shader><surface type='Ball' name='b'><size "
      "name='s'>1</size></surface>\n";
  EXPECT_THAT(refusal(named + "<surface ref='p'/>"), HasSubstr("3:1: 'p' names a shader, expected a surface"));
  EXPECT_THAT(refusal(named + "<surface ref='s'/>"), HasSubstr("3:1: 's' names one number, expected a surface"));
  EXPECT_THAT(refusal(named + "<surface type='Ball'><size ref='b'/></surface>"),
              HasSubstr("3:22: 'b' names a surface, expected one number"));
  EXPECT_THAT(refusal(named + "<surface type='Ball'><middle ref='s'/></surface>"),
              HasSubstr("'s' names one number, expected three numbers"));
  EXPECT_THAT(refusal(named + "<surface type='Ball'><count ref='s'/></surface>"),
              HasSubstr("'s' names one number, expected one whole number"));
}

TEST(ReadScene, ARefWithContentIsRefused) {
  const std::string named = "<surface type='Ball' name='b'><size name='s'>1</size></surface>\n";
  EXPECT_THAT(refusal(named + "<surface ref='b'><size>2</size></surface>"),
              HasSubstr("3:18: <surface> has both a ref and content"));
  EXPECT_THAT(refusal(named + "<surface type='Ball'><size ref='s'>2</size></surface>"),
              HasSubstr("3:36: <size> has both a ref and content"));
  EXPECT_EQ(refusal(named + "<surface ref='b'> <!-- nothing --> </surface>"), "");
}

TEST(ReadScene, ANameGivenTwiceMeansTheLaterFromThereOn) {
  const auto scene = read_elements(
      "<surface type='Ball' name='b'/><surface ref='b'/>\n<surface type='Ball' name='b'/><surface ref='b'/>");
  EXPECT_EQ(surface(scene, 1), surface(scene, 0));
  EXPECT_EQ(surface(scene, 3), surface(scene, 2));
  EXPECT_NE(surface(scene, 2), surface(scene, 0));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("s.xml:3:1: warning: the name 'b' was given before")));
}

TEST(ReadScene, CommentsAndCDataWithinText) {
  const auto scene = read_elements(
      "<!-- a --><surface type='Ball'><!-- b --><middle>1 <!-- 9 -->2<!-- -->\n0<![CDATA[.5]]></middle></surface>");
  EXPECT_EQ(surface(scene)->point("middle"), (Point3{1, 2, 0.5}));
}

TEST(ReadScene, CharacterReferencesAreRead) {
  EXPECT_EQ(surface(read_elements("<surface type='Ball'><size>&#52;2</size></surface>"))->number("size"), 42);
  EXPECT_EQ(surface(read_elements("<surface type='Ball'><picture>a&amp;b</picture></surface>"))->file_name("picture"),
            "a&b");
}

TEST(ReadScene, PositionsAreThoseOfTheTags) {
  const auto scene =
      read_elements("  <surface type='Ball'>\r\n\t<size>1</size>\r\n<!-- -->  <middle>1 2 3</middle>\r\n  </surface>");
  EXPECT_EQ(to_string(surface(scene)->where()), scene.file.string() + ":2:3");
  EXPECT_EQ(to_string(surface(scene)->where("size")), scene.file.string() + ":3:2") << "a tab is one column";
  EXPECT_EQ(to_string(surface(scene)->where("middle")), scene.file.string() + ":4:11");
  EXPECT_EQ(to_string(surface(scene)->where("count")), scene.file.string() + ":2:3")
      << "not given: the element's own place";
  EXPECT_EQ(to_string(scene.scene->where()), scene.file.string() + ":1:1");
}

TEST(ReadScene, ColumnsCountBytes) {
  // The comment takes 11 bytes for 10 characters, so the tag stands in column 12.
  const auto scene = read_elements("<!-- \xc3\xa4 --><surface type='Ball'/>");
  EXPECT_EQ(surface(scene)->where().column, 12);
}

TEST(ReadScene, RequiredElementsAreRequired) {
  EXPECT_THAT(refusal("\n <shader type='Paint'/>"),
              HasSubstr("3:2: <shader> of kind Paint lacks <tint>, expected three numbers (red green blue)"));
}

TEST(ReadScene, UnknownTagsNameTheKnownOnes) {
  EXPECT_THAT(refusal("<surface type='Ball'>\n<midle>1 2 3</midle></surface>"),
              HasSubstr("3:1: unknown tag <midle> in Ball, expected shader, middle, size, width, count, picture; did "
                        "you mean 'middle'?"));
  EXPECT_THAT(refusal("<light>\n<position>1 2 3</position></light>"),
              HasSubstr("3:1: unknown tag <position> in Lamp, expected no elements"));
}

TEST(ReadScene, ShadersNest) {
  const auto scene =
      read_elements("<shader type='Paint'><tint>1 1 1</tint><under type='Paint'><tint>0 1 0</tint></under></shader>");
  EXPECT_EQ(scene.scene->objects("shader").at(0)->object("under")->color("tint"), (Color{0, 1, 0}));
}

TEST(ReadScene, NothingButTheSceneIsOpened) {
  EXPECT_EQ(refusal("<surface type='Ball'><picture>/no/such/file</picture></surface>"), "");
}

TEST(ReadScene, WhiteSpaceBetweenCommentsSeparatesNumbers) {
  EXPECT_EQ(read_text("<scene><image>1<!--a--> <!--b-->2</image></scene>").scene->size("image"), (Size2{1, 2}));
}

}  // namespace
}  // namespace plumb
