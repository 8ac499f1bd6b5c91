#include "conformance/subject/kernel_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "conformance/sandbox/end_processes.h"
#include "conformance/sandbox/process_memory.h"

namespace plumb {
namespace {

using Clock = std::chrono::steady_clock;

/// How often the memory is looked at while an answer is awaited. A process that fills pages as fast as it can gets
/// some 100 MB further meanwhile.
constexpr std::chrono::milliseconds kLook{20};
/// Output taken from the log's pipe at a time.
constexpr std::int64_t kLogPiece = 1 << 20;
/// For a process that has closed the line to end by itself, so that its exit status tells why.
constexpr std::chrono::milliseconds kGrace{1000};

std::vector<std::string> own_environment() {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable; ++variable) variables.emplace_back(*variable);
  return variables;
}

}  // namespace

KernelProcess::KernelProcess(const std::filesystem::path& host, const std::filesystem::path& library,
                             std::int64_t memory_bytes, LogCapture& log)
    : log_(log), memory_bytes_(memory_bytes) {
  std::array<int, 2> ends;
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot make a socket pair");
  line_ = FileDescriptor(ends[0]);
  const FileDescriptor its_end(ends[1]);
  ::fcntl(line_.get(), F_SETFL, O_NONBLOCK);
  ProcessRequest request;
  request.arguments = {host.string(), library.string()};
  request.folder = std::filesystem::current_path();
  request.environment = own_environment();
  request.limits.cpu_seconds = std::numeric_limits<double>::infinity();  // the time is watched by question
  request.input = its_end.get();
  process_ = start_process(request);
  if (process_.pid < 0) throw std::runtime_error("the kernel's host does not start: " + process_.error);
}

KernelProcess::~KernelProcess() { end(); }

/// Kills what is left, and waits for it. The wait status, or 0 if it was no more.
int KernelProcess::end() {
  if (process_.pid < 0) return 0;
  // The group before its leader is waited for: until then nobody else can get its number.
  ::kill(-process_.pid, SIGKILL);
  int status = 0;
  while (::waitpid(process_.pid, &status, 0) < 0 && errno == EINTR) {
  }
  process_.pid = -1;
  line_.reset();
  drain(process_.log.get(), 4 * kLogPiece, log_);
  return status;
}

void KernelProcess::fail(Verdict verdict, const char* cause, const std::string& sentence) {
  end();
  throw SubjectFailure(verdict, cause, sentence);
}

void KernelProcess::fail_as_ended() {
  const auto deadline = Clock::now() + kGrace;
  while (!has_ended(process_.pid)) {
    if (Clock::now() >= deadline) fail(Verdict::fail, "protocol", "the kernel closed the line to its host");
    drain(process_.log.get(), kLogPiece, log_);
    ::usleep(500);
  }
  const int status = end();
  if (WIFSIGNALED(status)) {
    const char* name = ::sigdescr_np(WTERMSIG(status));
    throw SubjectFailure(
        Verdict::crash, "signal",
        fmt::format("the kernel was ended by signal {} ({})", WTERMSIG(status), name ? name : "unknown"));
  }
  if (WEXITSTATUS(status) != 0)
    throw SubjectFailure(Verdict::crash, "exit_status",
                         fmt::format("the kernel ended its process with exit status {}", WEXITSTATUS(status)));
  throw SubjectFailure(Verdict::fail, "protocol", "the kernel ended its process without an answer");
}

void KernelProcess::check_memory() {
  const std::optional<ProcessStat> process = read_process_stat(process_.pid);
  if (process && memory_of(*process).counted > memory_bytes_)
    fail(Verdict::memory_limit, "memory",
         fmt::format("the kernel holds more than {} MiB of memory", memory_bytes_ >> 20));
}

/// What is underway of one exchange.
class KernelProcess::Exchange {
 public:
  Exchange(KernelProcess& process, std::span<const std::byte> message, std::uint64_t most_bytes)
      : process_(process), unsent_(message), most_bytes_(most_bytes) {}

  bool sending() const { return !unsent_.empty(); }
  bool complete() const { return received_ == sizeof head_ + bytes_.size() && received_ >= sizeof head_; }
  KernelMessage take() { return {head_.word, std::move(bytes_)}; }

  void send() {
    const ssize_t sent = ::send(process_.line_.get(), unsent_.data(), unsent_.size(), MSG_NOSIGNAL);
    if (sent >= 0) {
      unsent_ = unsent_.subspan(static_cast<std::size_t>(sent));
    } else if (errno != EAGAIN && errno != EINTR) {
      process_.fail_as_ended();
    }
  }

  /// Takes what has come, up to the end of the message.
  void receive() {
    while (!complete()) {
      const bool in_head = received_ < sizeof head_;
      std::byte* to =
          in_head ? reinterpret_cast<std::byte*>(&head_) + received_ : bytes_.data() + received_ - sizeof head_;
      const std::size_t room = (in_head ? sizeof head_ : sizeof head_ + bytes_.size()) - received_;
      const ssize_t got = ::recv(process_.line_.get(), to, room, 0);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0 && errno == EAGAIN) return;
      if (got <= 0) process_.fail_as_ended();
      received_ += static_cast<std::size_t>(got);
      if (in_head && received_ == sizeof head_) check_head();
    }
  }

 private:
  void check_head() {
    if (head_.magic != KernelMessageHead::kMagic || head_.bytes > most_bytes_)
      process_.fail(Verdict::fail, "protocol", "what came from the kernel's host is no message");
    bytes_.resize(head_.bytes);
  }

  KernelProcess& process_;
  std::span<const std::byte> unsent_;
  std::uint64_t most_bytes_;
  KernelMessageHead head_{};
  std::size_t received_ = 0;
  std::vector<std::byte> bytes_;
};

KernelMessage KernelProcess::exchange(std::span<const std::byte> message, double seconds, std::uint64_t most_bytes) {
  if (process_.pid < 0) throw std::logic_error("the kernel's process has ended");
  const auto start = Clock::now();
  auto next_look = start + kLook;
  Exchange exchange(*this, message, most_bytes);
  bool log_open = true;
  while (!exchange.complete()) {
    std::array<pollfd, 2> ready{{{line_.get(), static_cast<short>(exchange.sending() ? POLLIN | POLLOUT : POLLIN), 0},
                                 {log_open ? process_.log.get() : -1, POLLIN, 0}}};
    ::poll(ready.data(), ready.size(), static_cast<int>(kLook.count()));
    if (ready[1].revents) log_open = drain(process_.log.get(), kLogPiece, log_);
    if (ready[0].revents & POLLOUT) exchange.send();
    if (ready[0].revents & (POLLIN | POLLHUP | POLLERR)) exchange.receive();
    if (exchange.complete() && exchange.sending())
      fail(Verdict::fail, "protocol", "an answer came before the question was whole");
    const auto now = Clock::now();
    if (now >= next_look && !exchange.complete()) {
      check_memory();
      next_look = now + kLook;
      if (std::chrono::duration<double>(now - start).count() > seconds)
        fail(Verdict::timeout, "wall_time", fmt::format("no answer of the kernel within {:g} s", seconds));
    }
  }
  drain(process_.log.get(), kLogPiece, log_);
  return exchange.take();
}

}  // namespace plumb
