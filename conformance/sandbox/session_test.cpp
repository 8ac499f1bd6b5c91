#include "conformance/sandbox/session.h"

#include <gmock/gmock.h>

#include <ostream>
#include <stdexcept>
#include <string>

#include "conformance/sandbox/run_fixture.h"

namespace plumb {

void PrintTo(SessionAnswer::Kind kind, std::ostream* out) { *out << static_cast<int>(kind); }

namespace {

using testing::HasSubstr;
using Kind = SessionAnswer::Kind;

constexpr std::size_t kLongest = 1 << 20;
/// No well-behaved program takes so long, on any machine.
constexpr double kSeconds = 60;

/// Conversations with a line of shell; its private line is number 3, as its environment says.
class SessionTest : public RunTest {
 protected:
  SessionRequest talk(const std::string& line) const {
    return {.process = shell(line), .line_variable = "TALK", .answer_prefix = "{"};
  }
  static std::string line_of(Session& session, const std::string& question = "") {
    const SessionAnswer answer = session.ask(question, kSeconds, kLongest);
    EXPECT_EQ(answer.kind, Kind::line);
    return answer.line;
  }
  static Kind kind_of(Session& session, const std::string& question = "", double seconds = kSeconds) {
    return session.ask(question, seconds, kLongest).kind;
  }
  /// The first answer of a program.
  Kind first_of(const std::string& line, double seconds = kSeconds) const {
    Session session(talk(line));
    return kind_of(session, "", seconds);
  }
};

TEST_F(SessionTest, TalksOnThePrivateLine) {
  Session session(talk("echo hello $TALK >&3; while read -r a <&3; do echo said $a; echo got $a >&3; done"));
  EXPECT_EQ(line_of(session), "hello 3");
  EXPECT_EQ(line_of(session, "one\n"), "got one");
  EXPECT_EQ(line_of(session, "two\n"), "got two");
  const RunOutcome& outcome = session.end();
  EXPECT_EQ(outcome.signal, SIGKILL);
  EXPECT_EQ(outcome.log, "said one\nsaid two\n");
  EXPECT_EQ(session.end().log, outcome.log);
}

TEST_F(SessionTest, TalksOnStandardInputAndOutput) {
  Session session(talk("echo start; echo '{hello'; while read -r a; do echo on $a; echo '{got' $a; done"));
  EXPECT_EQ(line_of(session), "{hello");
  EXPECT_EQ(line_of(session, "one\n"), "{got one");
  EXPECT_EQ(line_of(session, "two\n"), "{got two");
  EXPECT_EQ(session.end().log, "start\non one\non two\n");
}

TEST_F(SessionTest, EndsStandardInputForOneThatUsesThePrivateLine) {
  Session session(talk("echo hello >&3; cat; echo done >&3"));
  EXPECT_EQ(line_of(session), "hello");
  EXPECT_EQ(line_of(session), "done");
}

TEST_F(SessionTest, ReadsNoAnswersFromTheLog) {
  Session session(talk("echo '{ no' >&2; echo hello >&3; read -r a <&3; echo '{ neither'; echo yes >&3"));
  EXPECT_EQ(line_of(session), "hello");
  EXPECT_EQ(line_of(session, "one\n"), "yes");
  EXPECT_EQ(kind_of(session), Kind::ended);
  const RunOutcome& outcome = session.end();
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.log, HasSubstr("{ no\n"));
  EXPECT_THAT(outcome.log, HasSubstr("{ neither\n"));
}

TEST_F(SessionTest, HearsAChattyProgram) {
  const std::string much = "head -c 10000000 /dev/zero | tr '\\0' 'x'; echo";
  Session session(
      talk(much + "; " + much + " >&2; echo hello >&3; read -r a <&3; " + much + "; echo yes >&3; sleep 99"));
  EXPECT_EQ(line_of(session), "hello");
  EXPECT_EQ(line_of(session, "one\n"), "yes");
  const RunOutcome& outcome = session.end();
  EXPECT_LE(outcome.log.size(), (1u << 20) + 100);
  EXPECT_GT(outcome.log_bytes_dropped, 25'000'000);
}

TEST_F(SessionTest, IsNotHeldUpByOneThatPrintsAndDoesNotRead) {
  Session session(talk("echo '{hello'; while :; do head -c 1000000 /dev/zero; done"));
  EXPECT_EQ(line_of(session), "{hello");
  EXPECT_EQ(kind_of(session, std::string(8 << 20, 'q') + "\n", 0.5), Kind::too_late);
}

TEST_F(SessionTest, CarriesLongLinesBothWays) {
  for (const std::string& way : {std::string("cat <&3 >&3"), std::string("exec 3>&-; cat")}) {
    const bool on_line = way.find("<&3") != std::string::npos;
    Session session(talk("echo '{' " + std::string(on_line ? ">&3; " : "; ") + way));
    EXPECT_EQ(line_of(session), "{");
    const std::string question = "{" + std::string(5'000'000, 'q');
    const SessionAnswer answer = session.ask(question + "\n", kSeconds, question.size());
    EXPECT_EQ(answer.kind, Kind::line);
    EXPECT_TRUE(answer.line == question);
  }
}

TEST_F(SessionTest, RefusesLinesThatAreTooLong) {
  EXPECT_EQ(first_of("head -c 3000000 /dev/zero >&3; sleep 99"), Kind::too_long);
  EXPECT_EQ(first_of("cat /dev/zero >&3"), Kind::too_long);
  EXPECT_EQ(first_of("printf '{'; cat /dev/zero"), Kind::too_long);
}

TEST_F(SessionTest, WaitsNoLongerThanAllowed) {
  EXPECT_EQ(first_of("sleep 99", 0.2), Kind::too_late);
  EXPECT_EQ(first_of("cat /dev/zero", 0.2), Kind::too_late);
  EXPECT_EQ(first_of("printf half >&3; sleep 99", 0.2), Kind::too_late);
}

TEST_F(SessionTest, SeesHowItEnded) {
  EXPECT_EQ(first_of("exit 0"), Kind::ended);
  EXPECT_EQ(first_of("printf half >&3"), Kind::half_line);
  EXPECT_EQ(first_of("printf '{half'"), Kind::half_line);
  EXPECT_EQ(first_of("printf log"), Kind::ended);
  EXPECT_EQ(first_of("exec 3>&- >&-; sleep 99"), Kind::closed);
  EXPECT_EQ(first_of("sleep 99 & exit 0"), Kind::ended) << "its child still holds the line";

  Session crashed(talk("echo hello >&3; kill -SEGV $$"));
  EXPECT_EQ(line_of(crashed), "hello");
  EXPECT_EQ(kind_of(crashed, "one\n"), Kind::ended);
  EXPECT_EQ(crashed.end().signal, SIGSEGV);
  EXPECT_EQ(crashed.end().reason, StopReason::signalled);
}

TEST_F(SessionTest, DeliversWhatWasSaidBeforeTheEnd) {
  Session session(talk("echo a >&3; echo b >&3; exit 3"));
  EXPECT_EQ(line_of(session), "a");
  EXPECT_EQ(line_of(session), "b");
  EXPECT_EQ(kind_of(session), Kind::ended);
  EXPECT_EQ(session.end().exit_code, 3);
}

TEST_F(SessionTest, SaysThatAProgramCannotBeExecuted) {
  Session session({.process = request({"./none"}), .line_variable = "TALK", .answer_prefix = "{"});
  EXPECT_EQ(kind_of(session), Kind::ended);
  EXPECT_EQ(session.end().reason, StopReason::cannot_start);
  EXPECT_THAT(session.end().start_error, HasSubstr("No such file"));
}

TEST_F(SessionTest, HoldsItToItsLimits) {
  const auto stopped_by = [&](const ProcessRequest& process) {
    Session session({.process = process, .line_variable = "TALK", .answer_prefix = "{"});
    const SessionAnswer answer = session.ask("", kSeconds, kLongest);
    if (answer.kind == Kind::stopped) session.end(answer.reason);
    return session.end().reason;
  };
  ProcessRequest burner = subject({"burn", "100000"});
  burner.limits.cpu_seconds = 0.2;
  EXPECT_EQ(stopped_by(burner), StopReason::cpu_limit);
  ProcessRequest eater = subject({"allocate", "400", "1", "hold"});
  eater.limits.memory_bytes = 50 << 20;
  EXPECT_EQ(stopped_by(eater), StopReason::memory_limit);
  interrupt_flag() = true;
  EXPECT_EQ(stopped_by(shell("sleep 99")), StopReason::interrupted);
}

TEST_F(SessionTest, LeavesNothingBehind) {
  {
    Session session(talk("sleep 99 & (setsid sleep 99 &) ; trap '' TERM INT; echo hello >&3; sleep 99"));
    EXPECT_EQ(line_of(session), "hello");
    EXPECT_GE(marked_processes(), 2);
  }
  EXPECT_EQ(marked_processes(), 0);
}

TEST_F(SessionTest, IsOneAtATime) {
  {
    Session session(talk("sleep 99"));
    EXPECT_THROW(Session{talk("true")}, std::logic_error);
    EXPECT_THROW(run_process(shell("true")), std::logic_error);
    EXPECT_THROW(session.ask("too early\n", 1, kLongest), std::logic_error);
  }
  EXPECT_EQ(run_process(shell("exit 5")).exit_code, 5);
}

}  // namespace
}  // namespace plumb
