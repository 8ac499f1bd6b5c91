#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "conformance/sandbox/run_process.h"

namespace plumb {

/// Ends the calling process, a forked one, when its parent dies, and at the latest when no test runs any more.
[[noreturn]] inline void wait_for_the_end() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::sleep(100);
  ::_exit(0);
}

/// Forks a child that only waits to be killed, and leaves nothing behind should the test be killed first.
inline pid_t start_waiting_child() {
  const pid_t child = ::fork();
  if (child == 0) wait_for_the_end();
  return child;
}

/// Kills and waits for a child.
inline void end_child(pid_t child) {
  ::kill(child, SIGKILL);
  EXPECT_EQ(::waitpid(child, nullptr, 0), child);
}

/// A new empty folder for the time of a test.
class FolderTest : public testing::Test {
 protected:
  FolderTest() {
    std::string name = (std::filesystem::temp_directory_path() / "plumb-sandbox-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    folder_ = std::filesystem::canonical(name);
  }
  ~FolderTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  /// Writes a file of the folder and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  std::filesystem::path folder_;
};

/// Tests that run something. Each one ends with a look whether anything of it is left: neither a child, zombies
/// and adopted ones included, nor, found independently of the family tree, a process with the mark of this test
/// in its environment.
class RunTest : public FolderTest {
 protected:
  RunTest() { interrupt_flag() = false; }

  /// A run in the folder of the test with limits that no well-behaved subject reaches.
  ProcessRequest request(std::vector<std::string> arguments) const {
    ProcessRequest request;
    request.arguments = std::move(arguments);
    request.folder = folder_;
    request.writable_folder = folder_;
    request.environment = {"PATH=/usr/bin:/bin", mark()};
    request.limits.cpu_seconds = 60;
    request.limits.wall_seconds = 90;
    return request;
  }
  /// The same for the misbehaving program in one of its modes.
  ProcessRequest subject(std::vector<std::string> mode_and_arguments) const {
    mode_and_arguments.insert(mode_and_arguments.begin(), SANDBOX_SUBJECT);
    return request(std::move(mode_and_arguments));
  }
  /// The same for a line of shell.
  ProcessRequest shell(const std::string& line) const { return request({"/bin/sh", "-c", line}); }

  std::string mark() const { return "PLUMB_RUN_TEST=" + folder_.string(); }

  void TearDown() override {
    interrupt_flag() = false;
    errno = 0;
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG | __WALL), -1) << "a child is left";
    EXPECT_EQ(errno, ECHILD);
    EXPECT_EQ(marked_processes(), 0) << "a process of the run is left";
  }

  int marked_processes() const {
    int found = 0;
    std::error_code error;
    for (std::filesystem::directory_iterator process("/proc", error), end; process != end; process.increment(error)) {
      std::ifstream file(process->path() / "environ", std::ios::binary);
      const std::string environment{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
      if (environment.find(mark()) != std::string::npos) ++found;
    }
    return found;
  }
};

}  // namespace plumb
