#include "conformance/sandbox/session.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <limits>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace plumb {

namespace {

using Clock = WatchedProcess::Clock;
using std::chrono::milliseconds;

/// What is read from one descriptor before the others are looked at again.
constexpr std::size_t kReadAtOnce = 1 << 20;
/// How long one that has closed its line may take to end, so that it is known whether it did, and how.
constexpr milliseconds kTimeToEnd{500};
/// Reads once the program has ended: more than a pipe holds, but its descendants may go on writing.
constexpr int kReadsAtEnd = 16;

[[noreturn]] void fail() { throw std::system_error(errno, std::generic_category(), "cannot open a line to a program"); }

std::pair<FileDescriptor, FileDescriptor> make_pipe() {
  std::array<int, 2> ends;
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail();
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

std::pair<FileDescriptor, FileDescriptor> make_socket() {
  std::array<int, 2> ends;
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail();
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

void set_non_blocking(const FileDescriptor& descriptor) {
  const int flags = ::fcntl(descriptor.get(), F_GETFL);
  if (flags < 0 || ::fcntl(descriptor.get(), F_SETFL, flags | O_NONBLOCK) != 0) fail();
}

/// As write(2), but a pipe that nobody reads is the error EPIPE, and no signal.
ssize_t write_without_signal(int descriptor, std::string_view bytes) {
  sigset_t pipe_signal;
  sigset_t before;
  sigset_t pending;
  ::sigemptyset(&pipe_signal);
  ::sigaddset(&pipe_signal, SIGPIPE);
  ::sigpending(&pending);
  ::pthread_sigmask(SIG_BLOCK, &pipe_signal, &before);
  const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
  const int error = errno;
  if (written < 0 && error == EPIPE && ::sigismember(&pending, SIGPIPE) == 0) {
    const timespec now{};
    ::sigtimedwait(&pipe_signal, nullptr, &now);
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return written;
}

/// Reads what is there. Nothing once the descriptor is closed; it is then given up.
std::string read_some(FileDescriptor& from) {
  std::string bytes;
  std::array<char, 65'536> buffer;
  while (from.valid() && bytes.size() < kReadAtOnce) {
    const ssize_t count = ::read(from.get(), buffer.data(), buffer.size());
    if (count > 0) {
      bytes.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
      from.reset();
    } else if (errno == EAGAIN) {
      break;
    }
  }
  return bytes;
}

}  // namespace

Session::Session(const SessionRequest& request) : answers_(request.answer_prefix) {
  auto [line, their_line] = make_socket();
  auto [their_input, input] = make_pipe();
  auto [output, their_output] = make_pipe();
  for (const FileDescriptor* descriptor : {&line, &input, &output}) set_non_blocking(*descriptor);
  ::fcntl(output.get(), F_SETPIPE_SZ, 1 << 20);  // Fewer switches for a talkative program; not vital.

  ProcessRequest process = request.process;
  process.environment.push_back(request.line_variable + "=" + std::to_string(ProcessRequest::kLine));
  process.limits.wall_seconds = std::numeric_limits<double>::infinity();
  process.input = their_input.get();
  process.output = their_output.get();
  process.line = their_line.get();
  process_.emplace(process);
  line_ = std::move(line);
  input_ = std::move(input);
  output_ = std::move(output);
}

Session::~Session() = default;

SessionAnswer Session::ask(std::string question, double seconds, std::size_t longest_line) {
  if (!question.empty() && way_ == Way::undecided) throw std::logic_error("Session: asked before the first line came");
  using Kind = SessionAnswer::Kind;
  unsent_ = std::move(question);
  sent_ = 0;
  const Clock::time_point deadline =
      Clock::now() + std::chrono::ceil<milliseconds>(std::chrono::duration<double>(seconds));
  std::optional<Clock::time_point> closed_since;
  SessionAnswer answer;
  const auto over = [&](Kind kind) {
    answer.kind = kind;
    return std::move(answer);
  };
  for (int reads_at_end = 0;;) {
    // Asked before the reading: what it wrote before its end is then there to be read.
    const bool ended = !process_->started() || process_->has_ended();
    answer.ended = ended;
    const bool came = read_ways();
    process_->drain_log();
    if (take_line(answer.line)) return over(answer.line.size() > longest_line ? Kind::too_long : Kind::line);
    if (pending() > longest_line) return over(Kind::too_long);
    if (ended && (!came || ++reads_at_end == kReadsAtEnd)) return over(half_line() ? Kind::half_line : Kind::ended);
    if (closed() && !ended) {
      if (!closed_since) closed_since = Clock::now();
      if (Clock::now() - *closed_since > kTimeToEnd) return over(half_line() ? Kind::half_line : Kind::closed);
    }
    if (const std::optional<StopReason> reason = process_->look()) {
      answer.reason = *reason;
      return over(Kind::stopped);
    }
    if (Clock::now() >= deadline) return over(Kind::too_late);
    write_some();
    if (!came) wait(deadline);
  }
}

const RunOutcome& Session::end(StopReason reason) {
  flush_standard_output();
  return process_->end(reason);
}

bool Session::take_line(std::string& line) {
  for (const Way way : {Way::private_line, Way::standard}) {
    if (way_ != way && way_ != Way::undecided) continue;
    std::optional<std::string> taken = way == Way::standard ? answers_.take() : private_lines_.take();
    if (!taken) continue;
    if (way_ == Way::undecided) decide(way);
    line = std::move(*taken);
    return true;
  }
  return false;
}

void Session::decide(Way way) {
  way_ = way;
  if (way == Way::standard) {
    line_.reset();
  } else {
    input_.reset();
    process_->log(answers_.flush());
  }
}

bool Session::read_ways() {
  const std::string from_line = read_some(line_);
  private_lines_.append(from_line);
  const std::string from_output = read_some(output_);
  process_->log(way_ == Way::private_line ? from_output : answers_.append(from_output));
  return !from_line.empty() || !from_output.empty();
}

void Session::flush_standard_output() {
  for (int read = 0; read < kReadsAtEnd; ++read) {
    const std::string bytes = read_some(output_);
    process_->log(way_ == Way::private_line ? bytes : answers_.append(bytes));
    if (bytes.empty()) break;
  }
  process_->log(answers_.flush());
}

/// Whether no answer can come any more.
bool Session::closed() const {
  return (way_ == Way::standard || !line_.valid()) && (way_ == Way::private_line || !output_.valid());
}

bool Session::half_line() const {
  return (way_ != Way::standard && private_lines_.pending() > 0) ||
         (way_ != Way::private_line && answers_.pending() > 0 && answers_.in_answer());
}

std::size_t Session::pending() const {
  return std::max(way_ == Way::standard ? 0 : private_lines_.pending(),
                  way_ == Way::private_line ? 0 : answers_.pending());
}

void Session::write_some() {
  FileDescriptor& to = way_ == Way::standard ? input_ : line_;
  while (to.valid() && sent_ < unsent_.size()) {
    const ssize_t count = write_without_signal(to.get(), std::string_view(unsent_).substr(sent_));
    if (count > 0) {
      sent_ += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {
      return;
    } else if (errno != EINTR) {  // It does not read any more; it may yet say why, or end.
      unsent_.clear();
      sent_ = 0;
    }
  }
}

void Session::wait(Clock::time_point deadline) {
  const Clock::time_point until = std::min(deadline, process_->next_look());
  const auto time = std::chrono::ceil<milliseconds>(std::max(until - Clock::now(), Clock::duration::zero()));
  const bool sending = sent_ < unsent_.size();
  const bool standard = way_ == Way::standard;
  const auto wanted = [](bool reading, bool writing) {
    return static_cast<short>((reading ? POLLIN : 0) | (writing ? POLLOUT : 0));
  };
  std::array<pollfd, 5> events{{{process_->end_descriptor(), POLLIN, 0},
                                {process_->log_descriptor(), POLLIN, 0},
                                {line_.get(), wanted(true, sending && !standard), 0},
                                {output_.get(), POLLIN, 0},
                                {sending && standard ? input_.get() : -1, POLLOUT, 0}}};
  ::poll(events.data(), events.size(), static_cast<int>(time.count()));
}

}  // namespace plumb
