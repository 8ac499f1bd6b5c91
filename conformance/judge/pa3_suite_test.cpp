#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "conformance/judge/toml_fields.h"

// The shipped suite suites/pa3.toml against the scenes that it is made of.

namespace plumb {
namespace {

namespace fs = std::filesystem;

const fs::path kSuite = fs::path(PLUMB_SOURCE_DIR) / "suites/pa3.toml";
const fs::path kScenes = fs::path(PLUMB_SOURCE_DIR) / "scenes/pa3";

struct Pa3Case {
  std::string id, kind;
  fs::path scene;
  std::set<std::string> inputs;
  std::vector<std::string> prerequisites;
  double points = 0;
};

std::vector<std::string> texts(const toml::node_view<const toml::node>& list) {
  std::vector<std::string> found;
  if (const toml::array* array = list.as_array())
    for (const toml::node& entry : *array) found.push_back(entry.value<std::string>().value());
  return found;
}

std::vector<Pa3Case> suite_cases() {
  const toml::table suite = read_toml(kSuite);
  std::vector<Pa3Case> cases;
  for (const toml::node& node : *suite["case"].as_array()) {
    const toml::table& table = *node.as_table();
    Pa3Case c;
    c.id = table["id"].value<std::string>().value();
    c.kind = table["kind"].value_or<std::string>("image");
    c.scene = kSuite.parent_path() / table["scene"].value<std::string>().value();
    for (const std::string& input : texts(table["inputs"])) c.inputs.insert(fs::path(input).filename().string());
    c.prerequisites = texts(table["requires"]);
    c.points = table["points"].value<double>().value();
    cases.push_back(c);
  }
  return cases;
}

/// The files that a scene names as <data>.
std::set<std::string> meshes_of(const fs::path& scene) {
  std::ifstream stream(scene, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  static const std::regex kData("<data>\\s*(\\S+?)\\s*</data>");
  std::set<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), kData), end; at != end; ++at) names.insert((*at)[1]);
  return names;
}

TEST(Pa3Suite, AsksForEachSceneOnce) {
  std::multiset<std::string> asked, there;
  for (const Pa3Case& c : suite_cases()) {
    if (c.kind != "image") continue;
    EXPECT_EQ(c.scene.stem(), c.id);
    asked.insert(c.scene.filename().string());
  }
  for (const auto& entry : fs::directory_iterator(kScenes))
    if (entry.path().extension() == ".xml") there.insert(entry.path().filename().string());
  EXPECT_EQ(asked, there);
  EXPECT_EQ(asked.size(), 34U);
}

TEST(Pa3Suite, HandsOutTheMeshesThatItsScenesName) {
  std::set<std::string> handed_out;
  for (const Pa3Case& c : suite_cases()) {
    if (c.kind != "image") continue;
    EXPECT_EQ(c.inputs, meshes_of(c.scene)) << c.id;
    handed_out.insert(c.inputs.begin(), c.inputs.end());
  }
  std::set<std::string> there;
  for (const auto& entry : fs::directory_iterator(kScenes))
    if (entry.path().extension() == ".msh") there.insert(entry.path().filename().string());
  EXPECT_EQ(handed_out, there);
  EXPECT_EQ(handed_out.size(), 6U);
}

TEST(Pa3Suite, SharesOutAHundredPoints) {
  double points = 0;
  for (const Pa3Case& c : suite_cases()) points += c.points;
  EXPECT_EQ(points, 100);
}

TEST(Pa3Suite, AllButTheFirstCaseRequireKnownOnesWithoutACircle) {
  std::map<std::string, std::vector<std::string>> open;
  for (const Pa3Case& c : suite_cases()) open[c.id] = c.prerequisites;
  const std::size_t count = open.size();
  for (const auto& [id, prerequisites] : open) {
    EXPECT_EQ(prerequisites.empty(), id == "sphere") << id;
    for (const std::string& needed : prerequisites) EXPECT_TRUE(open.contains(needed)) << id << " needs " << needed;
  }
  std::set<std::string> settled;
  for (std::size_t round = 0; round < count; ++round)
    for (const auto& [id, prerequisites] : open)
      if (std::ranges::all_of(prerequisites, [&](const std::string& needed) { return settled.contains(needed); }))
        settled.insert(id);
  EXPECT_EQ(settled.size(), count);
}

TEST(Pa3Suite, ListsSixVariantsAndSchlickIsNone) {
  const toml::table suite = read_toml(kSuite);
  std::set<std::string> kinds;
  for (const toml::node& node : *suite["variant"].as_array()) {
    const toml::table& variant = *node.as_table();
    EXPECT_EQ(variant["fresnel"].value_or<std::string>(""), "exact");
    kinds.insert(variant["samples"].value<std::string>().value() +
                 (variant["cutoff"].value<bool>().value() ? "" : " without cutoff"));
  }
  EXPECT_THAT(kinds, ::testing::ElementsAre("down", "down without cutoff", "nearest", "nearest without cutoff", "up",
                                            "up without cutoff"));
}

}  // namespace
}  // namespace plumb
