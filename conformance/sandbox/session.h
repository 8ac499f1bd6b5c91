#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "conformance/sandbox/answer_lines.h"
#include "conformance/sandbox/file_descriptor.h"
#include "conformance/sandbox/run_outcome.h"
#include "conformance/sandbox/run_process.h"
#include "conformance/sandbox/watched_process.h"

namespace plumb {

/// A program to talk with, line by line.
struct SessionRequest {
  /// The limits hold for the whole session, but for the time on the clock, which each question has of its own.
  ProcessRequest process;
  /// The environment variable that tells the program the number of its private line.
  std::string line_variable;
  /// How an answer on standard output begins. Any other line there is log.
  std::string answer_prefix;
};

/// What came of one question.
struct SessionAnswer {
  enum class Kind {
    line,       ///< An answer: `line`, without its LF.
    too_late,   ///< None in time.
    too_long,   ///< A line longer than allowed.
    half_line,  ///< The program ended, or closed its line, in the middle of one.
    closed,     ///< It closed its line, but is alive.
    ended,      ///< It has ended; `Session::end` says how.
    stopped,    ///< It passed a limit, or the session was interrupted: `reason`.
  };
  Kind kind = Kind::line;
  std::string line;
  StopReason reason = StopReason::exited;
  bool ended = false;  ///< Whether the program had ended, where it is no line.
};

/// A conversation with a program that is not trusted, alive until the session ends. What is said at run_process of
/// isolation (there is none), processes and threads holds here too: a session is a run, one at a time in a process.
///
/// The program has a private line, a stream socket whose number stands in its environment, and standard input and
/// output. By which of them it sends its first line, it answers until the end: by the private line, where all lines are
/// answers, standard output is log and standard input ends; or by standard output, where lines with the prefix are
/// answers, and questions go to standard input. Standard error is log. However much it prints and however little it
/// reads, nobody waits for the other for ever.
class Session {
 public:
  /// Starts the program. Throws as run_process does; one that cannot be executed shows as `ended`.
  explicit Session(const SessionRequest& request);
  /// Ends the program and all that it started.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Sends the question (with its LF; nothing if empty) and waits for the next line. The first line comes unasked:
  /// until then nothing may be asked (std::logic_error). After anything but a line the session is of no more use: `end`
  /// it.
  SessionAnswer ask(std::string question, double seconds, std::size_t longest_line);

  /// Kills and reaps everything, and says what happened, with the log; a second call says the same.
  const RunOutcome& end(StopReason reason = StopReason::exited);

 private:
  enum class Way { undecided, private_line, standard };

  bool take_line(std::string& line);
  void decide(Way way);
  bool read_ways();
  void flush_standard_output();
  bool closed() const;
  bool half_line() const;
  std::size_t pending() const;
  void write_some();
  void wait(WatchedProcess::Clock::time_point deadline);

  Way way_ = Way::undecided;
  // Our ends; each is given up when it is closed or of no more use.
  FileDescriptor line_;
  FileDescriptor input_;
  FileDescriptor output_;
  LineSplitter private_lines_;
  AnswerFilter answers_;
  std::string unsent_;
  std::size_t sent_ = 0;
  std::optional<WatchedProcess> process_;
};

}  // namespace plumb
