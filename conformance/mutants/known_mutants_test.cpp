// The lint of the library of known bugs: what tools/mutants would only find out by building it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "conformance/checks/check.h"
#include "conformance/judge/toml_fields.h"
#include "conformance/mutants/mutant.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = PLUMB_SOURCE_DIR;
const fs::path kKnown = kRoot / "conformance/mutants/known";

TEST(KnownMutants, EveryPatchFitsItsSource) {
  int patched = 0;
  for (const Mutant& mutant : read_mutants(kKnown)) {
    for (const std::string& file : mutant.files()) {
      std::ifstream stream(kRoot / file, std::ios::binary);
      const std::string source(std::istreambuf_iterator<char>(stream), {});
      EXPECT_NO_THROW(EXPECT_NE(mutated_source(mutant, file, kRoot), source)) << mutant.id;
      ++patched;
    }
  }
  EXPECT_GE(patched, 60);
}

TEST(KnownMutants, EveryStepOfTheAssignmentHasSome) {
  std::set<std::string_view> seen;
  const std::vector<Mutant> mutants = read_mutants(kKnown);
  for (const Mutant& mutant : mutants) seen.insert(mutant.step);
  EXPECT_GE(mutants.size(), 60u);
  EXPECT_EQ(seen, std::set<std::string_view>(mutant_steps().begin(), mutant_steps().end()));
}

/// The ids of the suite's tables of that name.
std::set<std::string> ids_of(std::string_view tables) {
  const fs::path suite = kRoot / "suites/pa3.toml";
  const toml::table table = read_toml(suite);
  std::set<std::string> ids;
  for (const toml::table* each : TomlFields(table, suite, "the suite").tables(tables))
    ids.insert(each->at_path("id").value_or(std::string()));
  return ids;
}

TEST(KnownMutants, WhatMustCatchOrAcceptThemExists) {
  std::set<std::string> known = ids_of("case");
  EXPECT_THAT(known, testing::Contains("sphere"));
  for (const CheckKind* check : check_kinds()) known.insert("check:" + std::string(check->id));
  const std::set<std::string> variants = ids_of("variant");
  int names = 0;
  for (const Mutant& mutant : read_mutants(kKnown)) {
    for (const std::string& name : mutant.caught_by) {
      EXPECT_TRUE(known.contains(name)) << mutant.id << " is caught by " << name;
      ++names;
    }
    if (!mutant.accepted.empty()) {
      EXPECT_TRUE(variants.contains(mutant.accepted)) << mutant.id << " is " << mutant.accepted;
      ++names;
    }
  }
  EXPECT_GE(names, 60);
}

/// CMake reads no TOML: it finds what to compile again by lines of this form.
TEST(KnownMutants, TheFilesStandWhereTheBuildLooksForThem) {
  int files = 0;
  for (const Mutant& mutant : read_mutants(kKnown)) {
    std::ifstream stream(kKnown / (mutant.id + ".toml"));
    std::vector<std::string> found;
    for (std::string line; std::getline(stream, line);) {
      if (!line.starts_with("file = \"")) continue;
      const std::string file = line.substr(8, line.find('"', 8) - 8);
      if (std::ranges::find(found, file) == found.end()) found.push_back(file);
    }
    EXPECT_EQ(found, mutant.files()) << mutant.id;
    files += static_cast<int>(found.size());
  }
  EXPECT_GE(files, 60);
}

}  // namespace
}  // namespace plumb
