// `plumb corpus export`, run as a program, and the reader that is compiled with a C compiler alone.
#include <array>

#include "tools/plumb/program_for_tests.h"

namespace plumb {
namespace {

using testing::HasSubstr;

class CorpusCommandTest : public ProgramTest {
 protected:
  void compile_reader() {
    const std::string line =
        "cc -std=c99 -O2 -Wall -Wextra -Werror -ffp-contract=off -I '" PLUMB_SOURCE_DIR
        "/conformance/kernel' '" PLUMB_SOURCE_DIR "/examples/corpus-reader/read_corpus.c' -o reader";
    ASSERT_EQ(shell(line), 0) << complained_;
  }
};

TEST_F(CorpusCommandTest, TheReaderGetsTheFiguresOfTheCheck) {
  compile_reader();
  for (const std::string id : {"T0", "T1", "T2"}) {
    // A tenth of the check's 100,000 rays.
    ASSERT_EQ(plumb("corpus export --family " + id + " --count 10000 --seed 9 --out corpus.bin"), 0) << complained_;
    ASSERT_EQ(shell("./reader corpus.bin"), 0) << complained_;
    const std::string read = said_;
    plumb("check mt-float --filter " + id + " --intensity 0.1 --seed 9 --json");
    const auto evidence = nlohmann::json::parse(said_)["cases"][0]["evidence"];
    const auto figure = [&](const char* name) { return std::to_string(evidence[name].get<int>()); };
    EXPECT_EQ(read, id + ": " + figure("rays") + " rays, " + figure("free") + " free, " + figure("false_misses") +
                        " false misses, " + figure("false_hits") + " false hits\n");
    EXPECT_GE(evidence["rays"].get<int>(), 10000);
    const int wrong = evidence["false_misses"].get<int>() + evidence["false_hits"].get<int>();
    EXPECT_GE(wrong, id == "T0" ? 0 : 100) << id;
  }
}

TEST_F(CorpusCommandTest, TheSameSeedGivesTheSameBytes) {
  for (const std::string name : {"a.bin", "b.bin"})
    EXPECT_EQ(plumb("corpus export --family S3 --count 100 --seed 2 --precision double --out " + name), 0)
        << complained_;
  EXPECT_EQ(content("a.bin"), content("b.bin"));
  // Whole cases of 12 rays: 108 records of 424 bytes behind a header of 48.
  EXPECT_EQ(content("a.bin").size(), 48u + 108u * 424u);
  EXPECT_EQ(plumb("corpus export --family S3 --count 100 --seed 3 --precision double --out b.bin"), 0);
  EXPECT_NE(content("a.bin"), content("b.bin"));
}

TEST_F(CorpusCommandTest, TheReaderRefusesWhatIsNoCorpusOfTriangles) {
  compile_reader();
  write("text.bin", "this is no corpus, but a text that is longer than a header");
  for (const std::string words : {"./reader", "./reader missing.bin", "./reader text.bin"}) {
    EXPECT_EQ(shell(words), 2) << words;
    EXPECT_THAT(complained_, HasSubstr("usage: read_corpus CORPUS")) << words;
  }
  ASSERT_EQ(plumb("corpus export --family S0 --count 12 --out spheres.bin"), 0);
  EXPECT_EQ(shell("./reader spheres.bin"), 2);
  EXPECT_THAT(complained_, HasSubstr("this kernel knows triangles only"));
  // Half a corpus.
  ASSERT_EQ(plumb("corpus export --family T0 --count 12 --out whole.bin"), 0);
  write("half.bin", content("whole.bin").substr(0, 3000));
  EXPECT_EQ(shell("./reader half.bin"), 2);
}

TEST_F(CorpusCommandTest, MistakesInTheCommandAreStatusTwo) {
  const std::array<std::array<const char*, 2>, 6> mistakes{
      {{"corpus", "subcommand"},
       {"corpus export --out x.bin", "--family is required"},
       {"corpus export --family T22 --out x.bin", "did you mean 'T2'?"},
       {"corpus export --family T12 --out x.bin", "this family is made of meshes"},
       {"corpus export --family T1 --precision half --out x.bin", "--precision"},
       {"corpus export --family T1 --count 12 --out missing/x.bin", "cannot be written"}}};
  for (const auto& [words, message] : mistakes) {
    EXPECT_EQ(plumb(words), 2) << words;
    EXPECT_THAT(complained_, HasSubstr(message)) << words;
  }
}

}  // namespace
}  // namespace plumb
