#include "conformance/sandbox/start_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <string_view>
#include <system_error>
#include <utility>

namespace plumb {

namespace {

constexpr int kReportNumber = ProcessRequest::kLine + 1;  // In the child, until it executes.

/// What the child could not do.
enum class Stage { prepare, enter, execute };
struct Report {
  Stage stage;
  int error;
};

struct Limit {
  int resource;
  rlimit value;
};

/// All that the child needs, made before the fork: after it nothing may be allocated.
struct Plan {
  const char* folder;
  std::vector<std::string> candidates;  // The files to try, in order.
  std::vector<char*> arguments;
  std::vector<char*> shell_arguments;  // For a file without a known format; the second one is the candidate.
  std::vector<char*> environment;
  std::array<Limit, 3> limits;
  pid_t parent;
  int input;
  int output;
  int errors;
  int line;  // -1 for none.
  int report;
  int highest_descriptor;
};

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

std::vector<std::string> find_candidates(const ProcessRequest& request) {
  const std::string& program = request.arguments.front();
  if (program.find('/') != std::string::npos) return {program};
  std::string_view path = "/bin:/usr/bin";
  for (const std::string& variable : request.environment) {
    if (variable.starts_with("PATH=")) path = std::string_view(variable).substr(5);
  }
  std::vector<std::string> candidates;
  for (;;) {
    const std::string_view folder = path.substr(0, path.find(':'));
    candidates.push_back((folder.empty() ? "." : std::string(folder)) + "/" + program);
    if (folder.size() == path.size()) return candidates;
    path.remove_prefix(folder.size() + 1);
  }
}

/// The wish, or less where we may not raise our own limit that far.
Limit limit_of(int resource, double soft, double hard) {
  rlimit own;
  if (::getrlimit(static_cast<__rlimit_resource_t>(resource), &own) != 0) fail("cannot read a resource limit");
  const auto bounded = [&](double wish) {
    return wish < 1e18 ? std::min(static_cast<rlim_t>(wish), own.rlim_max) : own.rlim_max;
  };
  return {resource, {bounded(soft), bounded(hard)}};
}

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const std::string& text : texts) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

[[noreturn]] void give_up(Stage stage) {
  const Report report{stage, errno};
  [[maybe_unused]] const ssize_t written = ::write(kReportNumber, &report, sizeof report);
  ::_exit(127);
}

void require(bool done) {
  if (!done) give_up(Stage::prepare);
}

void close_all_but_standard_and_report(int highest) {
  if (::syscall(SYS_close_range, kReportNumber + 1, ~0U, 0) == 0) return;
  for (int number = kReportNumber + 1; number < highest; ++number) ::close(number);  // A kernel before 5.9.
}

/// In the child. Only calls that POSIX allows between fork and exec, and bare system calls.
[[noreturn]] void become(Plan& plan) {
  require(::dup3(plan.report, kReportNumber, O_CLOEXEC) == kReportNumber);
  ::close(ProcessRequest::kLine);
  if (plan.line >= 0) require(::dup2(plan.line, ProcessRequest::kLine) == ProcessRequest::kLine);
  require(::dup2(plan.input, 0) == 0 && ::dup2(plan.output, 1) == 1 && ::dup2(plan.errors, 2) == 2);
  close_all_but_standard_and_report(plan.highest_descriptor);

  // If we are killed, so is it; and if that happened already, there is nobody to work for.
  require(::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0);
  if (::getppid() != plan.parent) ::_exit(127);
  require(::setsid() >= 0);
  require(::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0);
  ::umask(022);
  for (const Limit& limit : plan.limits) {
    require(::setrlimit(static_cast<__rlimit_resource_t>(limit.resource), &limit.value) == 0);
  }
  // If memory runs out faster than we look, the system shall take this one first. Not vital.
  if (const int score = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); score >= 0) {
    [[maybe_unused]] const ssize_t written = ::write(score, "1000", 4);
    ::close(score);
  }

  struct sigaction usual = {};
  usual.sa_handler = SIG_DFL;
  for (int signal = 1; signal < NSIG; ++signal) ::sigaction(signal, &usual, nullptr);  // Some refuse; they have none.
  sigset_t none;
  ::sigemptyset(&none);
  require(::sigprocmask(SIG_SETMASK, &none, nullptr) == 0);

  if (::chdir(plan.folder) != 0) give_up(Stage::enter);
  bool denied = false;
  for (const std::string& file : plan.candidates) {
    ::execve(file.c_str(), plan.arguments.data(), plan.environment.data());
    if (errno == ENOEXEC) {
      plan.shell_arguments[1] = const_cast<char*>(file.c_str());
      ::execve("/bin/sh", plan.shell_arguments.data(), plan.environment.data());
    }
    // As a shell does: one that may not be run is passed over, but remembered.
    if (errno == EACCES) denied = true;
    if (errno != EACCES && errno != ENOENT && errno != ENOTDIR) break;
  }
  if (denied && (errno == ENOENT || errno == ENOTDIR)) errno = EACCES;
  give_up(Stage::execute);
}

/// The descriptor, moved away from the numbers that the child overwrites.
FileDescriptor above_fixed(int number) {
  FileDescriptor low(number);
  if (!low.valid()) fail("cannot open what a run needs");
  if (number > kReportNumber) return low;
  FileDescriptor high(::fcntl(number, F_DUPFD_CLOEXEC, kReportNumber + 1));
  if (!high.valid()) fail("cannot open what a run needs");
  return high;
}

/// A copy of the caller's descriptor, above those numbers; none for none.
FileDescriptor copy_of(int number) {
  if (number < 0) return FileDescriptor();
  return above_fixed(::fcntl(number, F_DUPFD_CLOEXEC, kReportNumber + 1));
}

struct Pipe {
  FileDescriptor read;
  FileDescriptor write;
};

Pipe make_pipe() {
  std::array<int, 2> ends;
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("cannot make a pipe");
  Pipe pipe{FileDescriptor(ends[0]), FileDescriptor(ends[1])};
  return {above_fixed(pipe.read.release()), above_fixed(pipe.write.release())};
}

pid_t fork_without_handlers(Plan& plan) {
  // Until the child has reset them, our own handlers must not run in it.
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t child = ::fork();
  if (child == 0) become(plan);
  const int error = errno;
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  if (child < 0) fail("cannot fork");
  return child;
}

std::string describe(const Report& report, const ProcessRequest& request) {
  const std::string reason = std::generic_category().message(report.error);
  if (report.stage == Stage::enter) return "cannot enter " + request.folder.string() + ": " + reason;
  return "cannot run " + request.arguments.front() + ": " + reason;
}

}  // namespace

StartedProcess start_process(const ProcessRequest& request) {
  const FileDescriptor input =
      request.input >= 0 ? copy_of(request.input) : above_fixed(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const FileDescriptor output = copy_of(request.output);
  const FileDescriptor line = copy_of(request.line);
  Pipe log = make_pipe();
  Pipe report = make_pipe();
  if (::fcntl(log.read.get(), F_SETFL, O_NONBLOCK) != 0) fail("cannot make a pipe");
  ::fcntl(log.read.get(), F_SETPIPE_SZ, 1 << 20);  // Fewer switches for a talkative program; not vital.

  const double cpu = std::ceil(request.limits.cpu_seconds);
  // One more than allowed, so that a file cut off there is seen to be too large even where the signal is ignored.
  const double file_bytes = static_cast<double>(request.limits.output_bytes) + 1;
  rlimit descriptors;
  if (::getrlimit(RLIMIT_NOFILE, &descriptors) != 0) fail("cannot read a resource limit");
  Plan plan{.folder = request.folder.c_str(),
            .candidates = find_candidates(request),
            .arguments = pointers(request.arguments),
            .shell_arguments = {},
            .environment = pointers(request.environment),
            .limits = {limit_of(RLIMIT_CPU, cpu + 1, cpu + 2), limit_of(RLIMIT_FSIZE, file_bytes, file_bytes),
                       limit_of(RLIMIT_CORE, 0, 0)},
            .parent = ::getpid(),
            .input = input.get(),
            .output = output.valid() ? output.get() : log.write.get(),
            .errors = log.write.get(),
            .line = line.get(),
            .report = report.write.get(),
            .highest_descriptor = static_cast<int>(std::min<rlim_t>(descriptors.rlim_cur, 1 << 20))};
  plan.shell_arguments = plan.arguments;
  plan.shell_arguments.insert(plan.shell_arguments.begin(), const_cast<char*>("/bin/sh"));

  StartedProcess started;
  started.pid = fork_without_handlers(plan);
  log.write.reset();
  report.write.reset();
  Report told;
  ssize_t size;
  while ((size = ::read(report.read.get(), &told, sizeof told)) < 0 && errno == EINTR) {
  }
  if (size != 0) {
    const pid_t child = std::exchange(started.pid, -1);
    while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
    errno = told.error;
    if (size != sizeof told || told.stage == Stage::prepare) fail("cannot prepare a process for a run");
    started.error = describe(told, request);
    return started;
  }
  started.end = FileDescriptor(static_cast<int>(::syscall(SYS_pidfd_open, started.pid, 0)));
  started.log = std::move(log.read);
  return started;
}

}  // namespace plumb
