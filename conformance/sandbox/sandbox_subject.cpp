// A program that misbehaves in the way its first argument names. It is run by the tests of the sandbox.

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <string>

namespace {

using Arguments = char**;

/// Argument `index` after the mode as a number.
long number(Arguments arguments, int index) { return std::strtol(arguments[index], nullptr, 10); }

double own_cpu_seconds() {
  timespec now;
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void burn(double seconds) {
  while (own_cpu_seconds() < seconds) {
  }
}

void touch(long megabytes, int sharing = MAP_PRIVATE) {
  const std::size_t size = static_cast<std::size_t>(megabytes) << 20;
  void* const memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, sharing | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) ::_exit(1);
  std::memset(memory, 1, size);
}

/// Long enough for any test, and yet nothing stays on the machine should the sandbox fail.
constexpr double kForEver = 100;
constexpr int kManyHops = 200'000;

void wait_for_ever() {
  ::sleep(static_cast<unsigned>(kForEver));
  ::_exit(0);
}

pid_t fork_or_die() {
  const pid_t child = ::fork();
  if (child < 0) ::_exit(1);
  return child;
}

/// Leaves its session and parent.
void daemonise() {
  if (fork_or_die() != 0) ::_exit(0);
  ::setsid();
  if (fork_or_die() != 0) ::_exit(0);
}

void* touch_in_thread(void* megabytes) {
  ::usleep(50'000);  // So that the main thread is gone before.
  touch(*static_cast<long*>(megabytes));
  wait_for_ever();
  return nullptr;
}

int burn_mode(Arguments a) {  // milliseconds
  burn(1e-3 * static_cast<double>(number(a, 0)));
  return 0;
}

int burn_in_children(Arguments a) {  // count, milliseconds each, "wait" or "ignore"
  if (std::strcmp(a[2], "ignore") == 0) ::signal(SIGCHLD, SIG_IGN);
  for (long i = number(a, 0); i > 0; --i) {
    if (fork_or_die() == 0) {
      burn(1e-3 * static_cast<double>(number(a, 1)));
      ::_exit(0);
    }
    ::wait(nullptr);
  }
  rusage own;
  rusage children;
  ::getrusage(RUSAGE_SELF, &own);
  ::getrusage(RUSAGE_CHILDREN, &children);
  const auto seconds = [](const rusage& u) {
    return static_cast<double>(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
  };
  std::printf("%.6f\n", seconds(own) + seconds(children));
  return 0;
}

int burn_as_daemon(Arguments) {  // The leader sleeps.
  if (fork_or_die() != 0) wait_for_ever();
  daemonise();
  burn(kForEver);
  return 0;
}

int burn_without_descriptors(Arguments) {
  ::close_range(0, ~0U, 0);
  burn(kForEver);
  return 0;
}

int hop(Arguments) {  // Always a new process, and its parent gone.
  for (int i = 0; i < kManyHops; ++i) {
    if (fork_or_die() != 0) ::_exit(0);
    ::setsid();
  }
  return 0;
}

int allocate(Arguments a) {  // megabytes, processes, "hold", "end" or "shared"
  const bool shared = std::strcmp(a[2], "shared") == 0;
  if (shared) touch(number(a, 0));
  for (long i = number(a, 1); i > 1; --i) {
    if (fork_or_die() == 0) {
      if (!shared) touch(number(a, 0));
      wait_for_ever();
    }
  }
  if (!shared) touch(number(a, 0));
  if (std::strcmp(a[2], "hold") == 0) wait_for_ever();
  if (shared) ::usleep(200'000);
  return 0;
}

int allocate_shared_memory(Arguments a) {  // megabytes
  touch(number(a, 0), MAP_SHARED);
  wait_for_ever();
  return 0;
}

int allocate_without_main_thread(Arguments a) {  // megabytes
  static long megabytes = number(a, 0);
  pthread_t thread;
  if (::pthread_create(&thread, nullptr, &touch_in_thread, &megabytes) != 0) return 1;
  ::pthread_exit(nullptr);
}

int print(Arguments a) {  // bytes; 0: for ever
  const std::string line(999, 'x');
  const long bytes = number(a, 0);
  for (long done = 0; bytes == 0 || done < bytes; done += 1000) std::puts(line.c_str());
  return 0;
}

int stop_itself(Arguments) {
  ::raise(SIGSTOP);
  return 0;
}

int ignore_signals(Arguments) {
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_IGN);
  wait_for_ever();
  return 0;
}

int daemon_mode(Arguments) {  // The leader ends at once.
  if (fork_or_die() != 0) return 0;
  daemonise();
  ::signal(SIGTERM, SIG_IGN);
  burn(kForEver);
  return 0;
}

int fork_bomb(Arguments a) {  // processes, "group" or "sessions"
  const bool sessions = std::strcmp(a[1], "sessions") == 0;
  for (long i = number(a, 0); i > 0; --i) {
    if (::fork() != 0) continue;
    if (sessions) ::setsid();
    if (i % 5 == 0) fork_or_die();
    if (i % 3 == 0) ::raise(SIGSTOP);
    if (i % 2 == 0) burn(kForEver);
    wait_for_ever();
  }
  wait_for_ever();
  return 0;
}

bool write_kilobytes(const char* name, long kilobytes) {
  const int file = ::open(name, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const std::string block(1024, 'x');
  bool good = file >= 0;
  for (long i = 0; good && i < kilobytes; ++i) good = ::write(file, block.data(), block.size()) > 0;
  ::close(file);
  return good;
}

int write_file(Arguments a) {  // name, kilobytes; goes on when the signal comes
  ::signal(SIGXFSZ, SIG_IGN);
  write_kilobytes(a[0], number(a, 1));
  return 0;
}

int write_files(Arguments a) {  // files, kilobytes each; then it waits
  for (long i = 0; i < number(a, 0); ++i) write_kilobytes(("file" + std::to_string(i)).c_str(), number(a, 1));
  wait_for_ever();
  return 0;
}

int write_sparse(Arguments) {
  return ::ftruncate(::open("sparse", O_WRONLY | O_CREAT, 0644), off_t{1} << 40) == 0 ? 0 : 1;
}

int print_state(Arguments) {  // open descriptors, session, signals, limits: what a program inherits
  for (int i = 0; i < 65'536; ++i) {
    if (::fcntl(i, F_GETFD) >= 0) std::printf("open %d\n", i);
  }
  sigset_t blocked;
  ::sigprocmask(SIG_SETMASK, nullptr, &blocked);
  for (int i = 1; i < NSIG; ++i) {
    struct sigaction action = {};
    if (::sigismember(&blocked, i) == 1) std::printf("blocked %d\n", i);
    if (::sigaction(i, nullptr, &action) == 0 && action.sa_handler != SIG_DFL) std::printf("handled %d\n", i);
  }
  rlimit core;
  ::getrlimit(RLIMIT_CORE, &core);
  std::printf("session %d\ngroup %d\numask %03o\ncore %ld\nprivileges %d\n", ::getsid(0) == ::getpid(),
              ::getpgrp() == ::getpid(), ::umask(0), static_cast<long>(core.rlim_max),
              ::prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) != 1);
  return 0;
}

const std::map<std::string, int (*)(Arguments)> kModes = {
    // clang-format off
    {"burn", burn_mode}, {"burn-in-children", burn_in_children}, {"burn-as-daemon", burn_as_daemon},
    {"burn-without-descriptors", burn_without_descriptors}, {"hop", hop}, {"allocate", allocate},
    {"allocate-shared-memory", allocate_shared_memory},
    {"allocate-without-main-thread", allocate_without_main_thread}, {"print", print}, {"stop-itself", stop_itself},
    {"ignore-signals", ignore_signals}, {"daemon", daemon_mode}, {"fork-bomb", fork_bomb}, {"write-file", write_file},
    {"write-files", write_files}, {"write-sparse", write_sparse}, {"print-state", print_state},
    // clang-format on
};

}  // namespace

int main(int count, char** arguments) {
  const auto mode = count > 1 ? kModes.find(arguments[1]) : kModes.end();
  if (mode == kModes.end()) return 99;
  return mode->second(arguments + 2);
}
