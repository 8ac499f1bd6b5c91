#include "conformance/sandbox/answer_lines.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace plumb {
namespace {

using testing::ElementsAre;

TEST(LineSplitter, CutsLinesHoweverTheyArrive) {
  const std::string text = "one\n\nthree\nhalf";
  for (std::size_t piece = 1; piece <= text.size(); ++piece) {
    LineSplitter splitter;
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size(); at += piece) {
      splitter.append(text.substr(at, piece));
      while (const auto line = splitter.take()) lines.push_back(*line);
    }
    EXPECT_THAT(lines, ElementsAre("one", "", "three")) << piece;
    EXPECT_EQ(splitter.pending(), 4u) << piece;
  }
}

TEST(AnswerFilter, TellsAnswersFromLogHoweverTheyArrive) {
  const std::string text = "log {a}\n{a}1\n{\n\n {a}2\n{b}\n{a}\n{a}half";
  for (std::size_t piece = 1; piece <= text.size(); ++piece) {
    AnswerFilter filter("{a}");
    std::string log;
    std::vector<std::string> answers;
    for (std::size_t at = 0; at < text.size(); at += piece) log += filter.append(text.substr(at, piece));
    while (const auto answer = filter.take()) answers.push_back(*answer);
    EXPECT_THAT(answers, ElementsAre("{a}1", "{a}")) << piece;
    EXPECT_EQ(log, "log {a}\n{\n\n {a}2\n{b}\n") << piece;
    EXPECT_EQ(filter.pending(), 7u) << piece;
    EXPECT_TRUE(filter.in_answer());
    EXPECT_EQ(filter.flush(), "{a}half");
  }
}

TEST(AnswerFilter, KeepsNothingOfAnEndlessLine) {
  AnswerFilter filter("{a}");
  std::size_t logged = 0;
  for (int i = 0; i < 100; ++i) logged += filter.append(std::string(1000, 'x')).size();
  EXPECT_EQ(logged, 100'000u);
  EXPECT_EQ(filter.pending(), 0u);
}

}  // namespace
}  // namespace plumb
