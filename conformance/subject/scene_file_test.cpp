#include "conformance/subject/scene_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "renderer/kinds.h"
#include "scenes/load_meshes.h"
#include "scenes/read_scene.h"
#include "scenes/scene_kind.h"

namespace plumb {
namespace {

class SceneFile : public testing::Test {
 protected:
  SceneFile()
      : folder_(std::filesystem::path(testing::TempDir()) / ("plumb-scene-file-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~SceneFile() override { std::filesystem::remove_all(folder_); }

  SceneDescription written(const SubjectScene& scene) const {
    return read_scene(write_scene_file(scene, folder_), renderer_kinds(Dialect::pa3_2011));
  }

  std::filesystem::path folder_;
};

SubjectSurface surface(ShapeKind kind) {
  SubjectSurface surface;
  surface.shape.kind = kind;
  surface.shape.center = {0.1, -1e-300, 1.0 / 3};
  surface.shape.radius = 1e17 / 3;
  surface.shape.height = std::numeric_limits<double>::denorm_min();
  surface.shape.tip_z = -0.0;
  surface.shape.min = {-1.1, -2.2, -3.3};
  surface.shape.max = {1.1, 2.2, 3.3};
  surface.shape.vertices = {{{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}};
  return surface;
}

TEST_F(SceneFile, ReadsBackToTheSameBits) {
  const SceneDescription read = written(
      {surface(ShapeKind::sphere), surface(ShapeKind::cylinder), surface(ShapeKind::cone), surface(ShapeKind::box)});
  EXPECT_TRUE(read.warnings.empty());
  const auto objects = read.scene->objects("surface");
  ASSERT_EQ(objects.size(), 4u);
  const Shape shape = surface(ShapeKind::sphere).shape;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(objects[i]->point("center"), shape.center);
    EXPECT_EQ(objects[i]->number("radius"), shape.radius);
    EXPECT_EQ(i > 0 ? objects[i]->number("height") : shape.height, shape.height);
  }
  EXPECT_TRUE(std::signbit(objects[2]->number("tipz")));
  EXPECT_EQ(objects[3]->point("minPt"), shape.min);
  EXPECT_EQ(objects[3]->point("maxPt"), shape.max);
  EXPECT_EQ(read.scene->objects("light").size(), 1u);
  EXPECT_TRUE(read.scene->has("camera"));
}

TEST_F(SceneFile, KeepsTheLinesOfGroupsInOrder) {
  SubjectSurface sphere = surface(ShapeKind::sphere);
  sphere.groups = {{{TransformStep::Kind::scale, {1.1, 2.2, -3.3}}, {TransformStep::Kind::translate, {4, 5, 6}}},
                   {},
                   {{TransformStep::Kind::rotate, {7, 8, 90.5}}}};
  const SceneDescription read = written({sphere});
  ObjectPointer at = read.scene->objects("surface").at(0);
  EXPECT_EQ(at->kind, &group_kind);
  ASSERT_EQ(at->properties.size(), 3u);
  EXPECT_EQ(at->properties[0].parameter->name, "scale");
  EXPECT_EQ(std::get<Vec3>(at->properties[0].value), (Vec3{1.1, 2.2, -3.3}));
  EXPECT_EQ(at->properties[1].parameter->name, "translate");
  at = at->objects("surface").at(0);
  EXPECT_EQ(at->properties.size(), 1u);
  at = at->objects("surface").at(0);
  EXPECT_EQ(at->properties[0].parameter->name, "rotate");
  EXPECT_EQ(at->objects("surface").at(0)->kind->name, "Sphere");
}

TEST_F(SceneFile, WritesASharedMeshOnce) {
  SubjectSurface triangle = surface(ShapeKind::triangle);
  SubjectSurface mesh = surface(ShapeKind::mesh);
  mesh.shape.mesh = file_mesh(triangle.shape);
  const SceneDescription read = written({mesh, triangle, mesh});
  const auto objects = read.scene->objects("surface");
  EXPECT_EQ(objects.at(0)->file_name("data"), objects.at(2)->file_name("data"));
  const MeshTable meshes = load_meshes(read);
  EXPECT_EQ(meshes.size(), 2u);
  for (const auto& [name, loaded] : meshes) EXPECT_EQ(*loaded, *mesh.shape.mesh) << name;
  EXPECT_EQ(file_mesh(surface(ShapeKind::box).shape), nullptr);
}

TEST_F(SceneFile, RefusesWhatAFileCannotHold) {
  SubjectSurface sphere = surface(ShapeKind::sphere);
  sphere.world_from_object = translation({1, 0, 0});
  EXPECT_THROW(write_scene_file({sphere}, folder_), UnsupportedBySubject);
  sphere.groups = {{{TransformStep::Kind::translate, {1, 0, 0}}}};
  EXPECT_NO_THROW(write_scene_file({sphere}, folder_));
  sphere.shape.radius = std::nan("");
  EXPECT_THROW(write_scene_file({sphere}, folder_), std::invalid_argument);
}

}  // namespace
}  // namespace plumb
