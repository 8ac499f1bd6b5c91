#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace plumb::bench {

struct ChildRun {
  int exit_status = 0;
  double cpu_seconds = 0;  ///< of user and system
};

/// Runs a program in `folder` without its output. Throws std::runtime_error if it cannot be started or is killed.
inline ChildRun run_child(std::vector<std::string> arguments, const std::filesystem::path& folder) {
  constexpr int kNoProgram = 127;
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int stream : {0, 1, 2}) dup2(nowhere, stream);
    if (chdir(folder.c_str()) == 0) execvp(pointers[0], pointers.data());
    _exit(kNoProgram);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) == kNoProgram)
    throw std::runtime_error(arguments[0] + " failed");
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {WEXITSTATUS(status), seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

}  // namespace plumb::bench
