#include "conformance/mutants/mutant.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Mutants : public testing::Test {
 protected:
  Mutants() { fs::create_directories(folder_); }
  ~Mutants() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

/// What an InputError says, or nothing where none is thrown.
template <class Action>
std::string refusal(Action action) {
  try {
    action();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

const std::string kWhole = R"(name = "Lights overwrite"
hint = "Add them up."
step = "lights"
file = "a.cpp"
find = '''sum += c;'''
replace = '''sum = c;'''
caught_by = ["two-lights", "check:O1"]
)";

std::string without(const std::string& line_start) {
  const std::size_t at = kWhole.find(line_start);
  return kWhole.substr(0, at) + kWhole.substr(kWhole.find('\n', at) + 1);
}

TEST_F(Mutants, AFileIsReadWhole) {
  const Mutant mutant = read_mutant(write("lights-overwrite.toml", kWhole));
  EXPECT_EQ(mutant.id, "lights-overwrite");
  EXPECT_EQ(mutant.name, "Lights overwrite");
  EXPECT_EQ(mutant.hint, "Add them up.");
  EXPECT_EQ(mutant.step, "lights");
  ASSERT_EQ(mutant.edits.size(), 1u);
  EXPECT_EQ(mutant.edits[0].file, "a.cpp");
  EXPECT_EQ(mutant.edits[0].find, "sum += c;");
  EXPECT_EQ(mutant.edits[0].replace, "sum = c;");
  EXPECT_THAT(mutant.caught_by, testing::ElementsAre("two-lights", "check:O1"));
  EXPECT_EQ(mutant.accepted + mutant.equivalent, "");
}

TEST_F(Mutants, SeveralEditsChangeSeveralFiles) {
  const auto edit = [](const std::string& file, const std::string& find) {
    return "[[edit]]\nfile = \"" + file + "\"\nfind = '''" + find + "'''\nreplace = ''''''\n";
  };
  const std::string start = "name = \"n\"\nhint = \"h\"\nstep = \"mesh\"\ncaught_by = [\"x\"]\n";
  const Mutant mutant =
      read_mutant(write("m.toml", start + edit("a.cpp", "one") + edit("b.cpp", "two") + edit("a.cpp", "three")));
  EXPECT_THAT(mutant.files(), testing::ElementsAre("a.cpp", "b.cpp"));
  write("a.cpp", "one, two, three, four");
  write("b.cpp", "one, two");
  EXPECT_EQ(mutated_source(mutant, "a.cpp", folder_), ", two, , four");
  EXPECT_EQ(mutated_source(mutant, "b.cpp", folder_), "one, ");
}

TEST_F(Mutants, AStalePatchIsRefused) {
  const Mutant mutant = read_mutant(write("m.toml", kWhole));
  write("a.cpp", "for (...) sum += colour;\n");
  EXPECT_EQ(refusal([&] { mutated_source(mutant, "a.cpp", folder_); }),
            "a.cpp: the text that a mutant replaces does not occur, expected it exactly once: 'sum += c;'");
  write("a.cpp", "sum += c;\nsum += c;\n");
  EXPECT_EQ(refusal([&] { mutated_source(mutant, "a.cpp", folder_); }),
            "a.cpp: the text that a mutant replaces occurs more than once, expected it exactly once: 'sum += c;'");
  fs::remove(folder_ / "a.cpp");
  EXPECT_THAT(refusal([&] { mutated_source(mutant, "a.cpp", folder_); }), HasSubstr("cannot read the source"));
  write("a.cpp", "{ sum += c; }\n");
  EXPECT_EQ(mutated_source(mutant, "a.cpp", folder_), "{ sum = c; }\n");
}

TEST_F(Mutants, OverlappingOccurrencesAreTwo) {
  EXPECT_THAT(refusal([] { apply({"a.cpp", "aa", "b"}, "aaa"); }), HasSubstr("more than once"));
}

TEST_F(Mutants, MalformedFilesAreRefusedAtTheirPlace) {
  const auto refused = [&](const std::string& text) { return refusal([&] { read_mutant(write("m.toml", text)); }); };
  ASSERT_EQ(refused(kWhole), "");
  for (const std::string key : {"name", "hint", "step", "find", "replace"})
    EXPECT_THAT(refused(without(key)), HasSubstr("'" + key + "' of the mutant is missing")) << key;
  EXPECT_THAT(refused(without("file")), HasSubstr("the mutant changes nothing"));
  EXPECT_THAT(refused(without("caught_by")), HasSubstr("'caught_by' of the mutant names nothing"));
  EXPECT_EQ(refused(without("caught_by") + "accepted = \"no-cutoff\"\n"), "");
  EXPECT_EQ(refused(without("caught_by") + "equivalent = \"The two sums are the same.\"\n"), "");
  EXPECT_THAT(refused(kWhole + "accepted = \"a\"\nequivalent = \"b\"\n"), HasSubstr("expected one of them"));
  EXPECT_THAT(refused(kWhole + "note = \"x\"\n"), HasSubstr("m.toml:8:8: unknown key 'note'"));
  EXPECT_THAT(refused(without("step") + "step = \"light\"\n"), HasSubstr("'light', expected one of camera"));
  EXPECT_THAT(refused(without("name") + "name = \" \"\n"), HasSubstr("'name' of the mutant is empty"));
  EXPECT_THAT(refused(without("replace") + "replace = '''sum += c;'''\n"), HasSubstr("expected a change"));
  EXPECT_THAT(refused(without("file") + "file = \"a.h\"\n"), HasSubstr("expected a .cpp file"));
  EXPECT_THAT(refused("name = "), HasSubstr("m.toml:1:"));
}

TEST_F(Mutants, AFolderIsReadInOrderAndNamesAreUnique) {
  EXPECT_THAT(refusal([&] { read_mutants(folder_); }), HasSubstr("the folder holds no mutant"));
  const auto named = [](const std::string& name, const std::string& hint) {
    return "name = \"" + name + "\"\nhint = \"" + hint + "\"\n" + kWhole.substr(kWhole.find("step"));
  };
  write("b.toml", named("B", "second"));
  write("a.toml", named("A", "first"));
  write("readme.md", "not a mutant");
  const std::vector<Mutant> mutants = read_mutants(folder_);
  ASSERT_EQ(mutants.size(), 2u);
  EXPECT_EQ(mutants[0].id + mutants[1].id, "ab");
  write("c.toml", named("A", "third"));
  EXPECT_THAT(refusal([&] { read_mutants(folder_); }), HasSubstr("c.toml: its name is also that of a"));
  write("c.toml", named("C", "second"));
  EXPECT_THAT(refusal([&] { read_mutants(folder_); }), HasSubstr("c.toml: its hint is also that of b"));
}

}  // namespace
}  // namespace plumb
