#include <gmock/gmock.h>

#include "renderer/scene_for_tests.h"

// Every way in which a scene of the default dialect can be wrong: its text, the exact place that the error
// names, and a part of what it says.

namespace plumb {
namespace {

using ::testing::HasSubstr;

struct Wrong {
  const char* name;
  std::string text;
  const char* place;  ///< `file:line:column` or `file`, without the folder
  const char* message;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

/// Elements that begin at line 2, column 1 of an otherwise sound scene.
std::string scene(const std::string& elements) { return "<scene><image>4 4</image>\n" + elements + "\n</scene>"; }

std::string mesh_scene(const std::string& file) {
  return scene("<surface type='Mesh'><data>" + file + "</data></surface>");
}

std::string nested(int depth) {
  std::string text;
  for (int i = 0; i < depth; ++i) text += "<surface type='Group'>";
  for (int i = 0; i < depth; ++i) text += "</surface>";
  return text;
}

void write_broken_meshes() {
  const std::string vertices = "3\n1\nvertices\n0\n0\n0\n1\n0\n0\n0\n1\n0\n";
  write_scene_test_file("truncated.msh", "3\n1\nvertices\n0\n0\n0\n1\n0\n0\n0\n1");
  write_scene_test_file("index.msh", vertices + "triangles\n0\n1\n3\n");
  write_scene_test_file("negative.msh", vertices + "triangles\n0\n-1\n2\n");
  write_scene_test_file("nan.msh", "3\n1\nvertices\n0\n0\nnan\n1\n0\n0\n0\n1\n0\ntriangles\n0\n1\n2\n");
  write_scene_test_file("empty.msh", "");
  write_scene_test_file("mesh.zip", "PK");
  std::filesystem::create_directories(scene_test_file("folder.xml"));
}

class WrongScene : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongScene, IsRefusedAtItsPlaceInOneLine) {
  write_broken_meshes();
  const Wrong& wrong = GetParam();
  const auto file = wrong.text.empty() ? scene_test_file(wrong.place) : write_scene_test_file("wrong.xml", wrong.text);
  try {
    read_and_build(file);
    FAIL() << "it was accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find_first_of("\r\n\t\x1b"), std::string::npos) << message;
    const std::string start = scene_test_file(wrong.place).string() + ": ";
    EXPECT_TRUE(message.starts_with(start)) << message;
    EXPECT_THAT(message, HasSubstr(wrong.message));
  }
}

const Wrong kXml[] = {
    {"Missing", "", "missing.xml", "cannot open the scene: No such file or directory"},
    {"Folder", "", "folder.xml", "this is a folder, expected a scene file"},
    {"Empty", " ", "wrong.xml:1:2", "no document element found"},
    {"OnlyAComment", "<!-- nothing -->", "wrong.xml:1:17", "no document element found"},
    {"NotXml", "hello", "wrong.xml:1:6", "no document element found"},
    {"Unclosed", "<scene>\n<image>4 4</image>\n", "wrong.xml:2:19", "malformed XML"},
    {"WrongEndTag", "<scene>\n<image>4 4</imago>\n</scene>", "wrong.xml:2:13",
     "malformed XML: start-end tags mismatch"},
    {"BrokenAttribute", "<scene>\n<light name=5/></scene>", "wrong.xml:2:13",
     "malformed XML: error parsing element attribute"},
    {"WrongRoot", "\n <picture/>", "wrong.xml:2:2", "the root element is <picture>, expected <scene>"},
    {"EntityUse", scene("<surface type='Sphere'><radius>&a;</radius></surface>"), "wrong.xml:2:24",
     "'&a;' is no such number"},
};
INSTANTIATE_TEST_SUITE_P(Xml, WrongScene, ::testing::ValuesIn(kXml), [](const auto& row) { return row.param.name; });

const Wrong kElements[] = {
    {"UnknownTag", scene("<light>\n <positon>1 2 3</positon></light>"), "wrong.xml:3:2",
     "unknown tag <positon> in Light, expected position, intensity, color; did you mean 'position'?"},
    {"UnknownTagOfScene", scene(" <ligth/>"), "wrong.xml:2:2", "did you mean 'light'?"},
    {"TagFarFromAll", scene("<zzzzzzzzzz/>"), "wrong.xml:2:1",
     "unknown tag <zzzzzzzzzz> in Scene, expected camera, image"},
    {"UnknownSurface", scene("<surface type='Shpere'/>"), "wrong.xml:2:1",
     "unknown type 'Shpere' of <surface>, expected one of Box, Cone, Cylinder, Mesh, Sphere, Group; did you mean "
     "'Sphere'?"},
    {"UnknownShader", scene("<shader type='ray.shader.Lambertain'/>"), "wrong.xml:2:1",
     "unknown type 'ray.shader.Lambertain' of <shader>, expected one of Glass, Glazed, Lambertian, Phong; did you mean "
     "'Lambertian'?"},
    {"ShaderAsSurface", scene("<surface type='Phong'/>"), "wrong.xml:2:1", "unknown type 'Phong' of <surface>"},
    {"NoType", scene("<surface/>"), "wrong.xml:2:1", "<surface> has no type"},
    {"UnknownAttribute", scene("<surface typ='Sphere'/>"), "wrong.xml:2:1",
     "unknown attribute 'typ' of <surface>, expected type, name, ref; did you mean 'type'?"},
    {"UnknownAttributeOfValue", scene("<surface type='Sphere'><radius unit='m'>1</radius></surface>"), "wrong.xml:2:24",
     "unknown attribute 'unit' of <radius>"},
    {"TypeOfValue", scene("<surface type='Sphere'><radius type='double'>1</radius></surface>"), "wrong.xml:2:24",
     "unknown attribute 'type' of <radius>, expected name, ref"},
    {"MissingRef", scene("<shader type='Phong' name='white'/>\n<surface type='Box'><shader ref='whit'/></surface>"),
     "wrong.xml:3:21", "nothing is named 'whit', expected the name of an earlier element; did you mean 'white'?"},
    {"EmptyRef", scene("<surface ref=''/>"), "wrong.xml:2:1", "nothing is named ''"},
    {"WrongRef", scene("<shader type='Phong' name='p'/>\n<surface ref='p'/>"), "wrong.xml:3:1",
     "'p' names a shader, expected a surface"},
    {"TextAmongElements", scene("<light>hello<position>1 2 3</position></light>"), "wrong.xml:2:8",
     "unexpected text in <light>, expected elements"},
    {"TextInScene", "<scene>x<image>4 4</image></scene>", "wrong.xml:1:8",
     "unexpected text in <scene>, expected elements"},
    {"ElementInValue", scene("<light><position>1 <b/> 2 3</position></light>"), "wrong.xml:2:20",
     "unexpected <b> in <position>, expected three numbers"},
    {"NestedTooDeep", scene(nested(3000)), "wrong.xml:2:22001", "elements are nested more than 1000 deep"},
    {"TwoCamerasOfUnknownKind", scene("<camera/><camera type='Fisheye'/>"), "wrong.xml:2:10",
     "unknown type 'Fisheye' of <camera>, expected one of Camera"},
};
INSTANTIATE_TEST_SUITE_P(Elements, WrongScene, ::testing::ValuesIn(kElements),
                         [](const auto& row) { return row.param.name; });

const Wrong kValues[] = {
    {"TooFewNumbers", scene("<light><position>1 2</position></light>"), "wrong.xml:2:8",
     "<position>: found 2 values, expected three numbers (x y z)"},
    {"TooManyNumbers", scene("<light><position>1 2 3 4</position></light>"), "wrong.xml:2:8", "found 4 values"},
    {"NoNumber", scene("<light><position/></light>"), "wrong.xml:2:8", "found nothing, expected three numbers"},
    {"NotANumber", scene("<light><position>1 2 c</position></light>"), "wrong.xml:2:8", "'c' is no such number"},
    {"Nan", scene("<light><position>1 nan 3</position></light>"), "wrong.xml:2:8", "'nan' is not a finite number"},
    {"Infinite", scene("<light><position>1 2 -inf</position></light>"), "wrong.xml:2:8",
     "'-inf' is not a finite number"},
    {"OutOfRange", scene("<light><position>1e999 2 3</position></light>"), "wrong.xml:2:8", "'1e999' is out of range"},
    {"NegativeRadius", scene("<surface type='Sphere'>\n<radius>-1</radius></surface>"), "wrong.xml:3:1",
     "<radius> must not be negative, but it is -1"},
    {"NegativeCylinder", scene("<surface type='Cylinder'><height>-2</height></surface>"), "wrong.xml:2:26",
     "<height> must not be negative, but it is -2"},
    {"NegativeCone", scene("<surface type='Cone'><tipz>3</tipz><height>-2</height></surface>"), "wrong.xml:2:36",
     "<height> must not be negative"},
    {"ZeroIndex", scene("<shader type='Glass'><refractiveIndex>0</refractiveIndex></shader>"), "wrong.xml:2:22",
     "<refractiveIndex> must be greater than zero, but it is 0"},
    {"MissingIndex", scene("<shader type='Glass'/>"), "wrong.xml:2:1",
     "<shader> of kind Glass lacks <refractiveIndex>, expected one number"},
    {"MissingSubstrate", scene("<shader type='Glazed'><refractiveIndex>2</refractiveIndex></shader>"), "wrong.xml:2:1",
     "lacks <substrate>, expected elements"},
    {"MissingImage", "\n<scene></scene>", "wrong.xml:2:1",
     "<scene> of kind Scene lacks <image>, expected two whole numbers"},
    {"EmptyImage", "<scene>\n<image>0 4</image></scene>", "wrong.xml:2:1", "<image> must be greater than zero"},
    {"NegativeImage", "<scene>\n<image>4 -4</image></scene>", "wrong.xml:2:1", "<image> must be greater than zero"},
    {"WideImage", "<scene>\n<image>65536 1</image></scene>", "wrong.xml:2:1",
     "a picture of 65536x1 is too large, expected at most 65535 a side and 268435456 pixels"},
    {"LargeImage", "<scene>\n<image>65535 65535</image></scene>", "wrong.xml:2:1",
     "a picture of 65535x65535 is too large"},
    {"ImageOfFractions", "<scene>\n<image>4.5 4</image></scene>", "wrong.xml:2:1",
     "'4.5' is no such number, expected two whole numbers"},
    {"ImageOutOfRange", "<scene>\n<image>99999999999 4</image></scene>", "wrong.xml:2:1",
     "'99999999999' is out of range"},
    {"NegativeSamples", scene("<samples>-1</samples>"), "wrong.xml:2:1", "<samples> must not be negative"},
    {"TooManySamples", scene("<samples>2147483647</samples>"), "wrong.xml:2:1", "<samples> must be at most 1048576"},
    {"TooDeep", scene("<maxDepth>100000000</maxDepth>"), "wrong.xml:2:1", "<maxDepth> must be at most 1000"},
    {"NegativeByRef", scene("<surface type='Cone'><tipz name='t'>-2</tipz>\n<radius ref='t'/></surface>"),
     "wrong.xml:3:1", "<radius> must not be negative"},
    {"RefOfAnotherType",
     scene("<shader type='Glass' name='g'><refractiveIndex>1.5</refractiveIndex></shader>\n<shader ref='g' "
           "type='Phong'/>"),
     "wrong.xml:3:1", "names a Glass"},
    {"AttributeGivenTwice", scene("<shader type='Phong' type='Glass'/>"), "wrong.xml:2:1", "given twice"},
    {"AttributeOfTheRoot", "<scene foo='1'><image>4 4</image></scene>", "wrong.xml:1:1", "unknown attribute 'foo'"},
    {"ZeroByte", std::string("<scene><image>4 4</image></scene>\0<x>", 38), "wrong.xml", "zero byte"},
    {"SecondOfTwoNumbers", "<scene>\n<image>300 0</image></scene>", "wrong.xml:2:1", "but it is 0"},
    {"FlatScaleHiddenByRotations",
     scene("<surface type='Group'><rotate>10 20 30</rotate>\n<scale>1 1 0</scale><rotate>40 50 60</rotate></surface>"),
     "wrong.xml:3:1", "the transform is singular"},
    {"EdgeOnView", scene("<camera><viewDir>18 8 1</viewDir>\n<projNormal>8 -18 0</projNormal></camera>"),
     "wrong.xml:3:1", "<projNormal> is perpendicular"},
    {"UpAlongViewInDecimals", scene("<camera><viewDir>0.3 0.6 0.9</viewDir>\n<viewUp>0.1 0.2 0.3</viewUp></camera>"),
     "wrong.xml:3:1", "<viewUp> is parallel"},
    {"ZeroDepth", scene("<maxDepth>0</maxDepth>"), "wrong.xml:2:1", "<maxDepth> must be greater than zero"},
};
INSTANTIATE_TEST_SUITE_P(Values, WrongScene, ::testing::ValuesIn(kValues),
                         [](const auto& row) { return row.param.name; });

const Wrong kThings[] = {
    {"MeshWithoutData", scene("<surface type='Mesh'/>"), "wrong.xml:2:1",
     "<surface> of kind Mesh lacks <data>, expected a file name"},
    {"MeshWithoutName", mesh_scene(" "), "wrong.xml:2:22", "<data> is empty, expected a file name"},
    {"MissingMesh", mesh_scene("none.msh"), "wrong.xml:2:22", "none.msh' does not exist"},
    {"TruncatedMesh", mesh_scene("truncated.msh"), "truncated.msh:11:2",
     "the file ends in the vertices: 8 of 9 numbers read"},
    {"MeshIndexOutOfRange", mesh_scene("index.msh"), "index.msh:16:1",
     "'3' is out of range; expected a vertex index from 0 to 2"},
    {"NegativeMeshIndex", mesh_scene("negative.msh"), "negative.msh:15:1", "'-1' is not a vertex index"},
    {"MeshWithNan", mesh_scene("nan.msh"), "nan.msh:6:1", "nan"},
    {"EmptyMesh", mesh_scene("empty.msh"), "empty.msh:1:1", "the file is empty"},
    {"UnknownMeshFormat", mesh_scene("mesh.zip"), "mesh.zip", "expected"},
    {"FlatScale", scene("<surface type='Group'><scale>1 0 1</scale></surface>"), "wrong.xml:2:23",
     "the transform is singular"},
    {"FlatTogetherWithGroup",
     scene("<surface type='Group'><scale>1e-200 1 1</scale>\n<surface type='Group'><scale>1e-200 1 "
           "1</scale></surface></surface>"),
     "wrong.xml:3:1", "the transform is singular"},
    {"ConeTipAtCenter", scene("<surface type='Cone'>\n<tipz>0</tipz></surface>"), "wrong.xml:3:1",
     "the cone's tip lies at the height of its centre"},
    {"ConeOfDefaults", scene("<surface type='Cone'/>"), "wrong.xml:2:1",
     "the cone's tip lies at the height of its centre"},
    {"ZeroViewDir", scene("<camera><viewDir>0 0 0</viewDir></camera>"), "wrong.xml:2:9",
     "<viewDir> is zero, expected a direction"},
    {"ZeroViewUp", scene("<camera><viewUp>0 0 0</viewUp></camera>"), "wrong.xml:2:9", "<viewUp> is zero"},
    {"ZeroProjNormal", scene("<camera><projNormal>0 0 0</projNormal></camera>"), "wrong.xml:2:9",
     "<projNormal> is zero"},
    {"UpAlongView", scene("<camera><viewUp>0 0 3</viewUp></camera>"), "wrong.xml:2:9",
     "<viewUp> is parallel to viewDir"},
    {"UpAlongViewByDefault", scene("<camera>\n<viewDir>0 -2 0</viewDir></camera>"), "wrong.xml:2:1",
     "<viewUp> is parallel to viewDir"},
    {"UpAlongProjNormal", scene("<camera><viewUp>0 1 1</viewUp>\n<projNormal>0 2 2</projNormal></camera>"),
     "wrong.xml:2:9", "<viewUp> is parallel to projNormal"},
    {"WindowEdgeOn", scene("<camera>\n<projNormal>0 1 0</projNormal></camera>"), "wrong.xml:3:1",
     "<projNormal> is perpendicular to viewDir"},
    {"ZeroProjDistance", scene("<camera><projDistance>0</projDistance></camera>"), "wrong.xml:2:9",
     "<projDistance> must be greater than zero"},
    {"NegativeViewWidth", scene("<camera><viewWidth>-1</viewWidth></camera>"), "wrong.xml:2:9",
     "<viewWidth> must be greater than zero"},
};
INSTANTIATE_TEST_SUITE_P(Things, WrongScene, ::testing::ValuesIn(kThings),
                         [](const auto& row) { return row.param.name; });

/// The error of a scene whose place is not known to the column.
void expect_refused_in_line(const std::string& text, int line, const std::string& message) {
  try {
    read_and_build(write_scene_test_file("wrong.xml", text));
    ADD_FAILURE() << "it was accepted: " << text;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(message));
    EXPECT_EQ(error.where().line, line);
  }
}

TEST(WrongScenes, ASecondRootIsRefused) {
  expect_refused_in_line("<scene><image>4 4</image></scene>\n<scene/>", 2,
                         "a second root element, expected one <scene>");
}

TEST(WrongScenes, DocumentTypesAndEntitiesAreRefused) {
  const std::string message = "a document type (<!DOCTYPE>) is not accepted";
  expect_refused_in_line("<?xml version='1.0'?>\n<!DOCTYPE scene SYSTEM 'a.dtd'><scene><image>4 4</image></scene>", 2,
                         message);
  expect_refused_in_line("<!DOCTYPE scene [<!ENTITY a 'aaaa'>]><scene><image>4 4</image>&a;</scene>", 1, message);
}

TEST(WrongScenes, NestingJustWithinTheLimitIsAccepted) {
  // The deepest element has depth 1000.
  const ReadScene read = read_and_build(write_scene_test_file("deep.xml", scene(nested(1000))));
  EXPECT_TRUE(read.scene.placed().empty());
}

}  // namespace
}  // namespace plumb
