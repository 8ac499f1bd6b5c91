#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <charconv>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include "tools/plumb/command.h"
#include "tools/plumb/probe_answers.h"

namespace plumb {
namespace {

using File = std::unique_ptr<FILE, int (*)(FILE*)>;

/// The private line that the environment names, or -1: then standard input and output stand in.
int private_line() {
  const char* const variable = ::getenv("PLUMB_PROBE_FD");
  if (variable == nullptr) return -1;
  const std::string_view text = variable;
  int number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool open = error == std::errc() && end == text.data() + text.size() && ::lseek(number, 0, SEEK_CUR) < 0 &&
                    errno == ESPIPE;  // what a socket says
  return open ? number : -1;
}

File open_line(int descriptor, const char* mode) {
  File file(::fdopen(::dup(descriptor), mode), &::fclose);
  if (!file) throw std::system_error(errno, std::generic_category(), "cannot open the probe's line");
  return file;
}

void send(const File& to, const std::string& line) {
  ::fwrite(line.data(), 1, line.size(), to.get());
  ::fputc('\n', to.get());
  if (::fflush(to.get()) != 0) throw std::system_error(errno, std::generic_category(), "cannot answer");
}

int run() {
  const int line = private_line();
  const File from = open_line(line >= 0 ? line : STDIN_FILENO, "r");
  const File to = open_line(line >= 0 ? line : STDOUT_FILENO, "w");
  ProbeAnswers answers;
  send(to, ProbeAnswers::greeting());
  char* buffer = nullptr;
  std::size_t capacity = 0;
  for (ssize_t size; (size = ::getline(&buffer, &capacity, from.get())) >= 0;) {
    const std::string answer = answers.answer(std::string(buffer, static_cast<std::size_t>(size)));
    if (answer.empty()) break;
    send(to, answer);
  }
  ::free(buffer);
  return 0;
}

}  // namespace

void add_probe_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "probe", "Answer the probe protocol: questions about a scene, as lines of JSON (docs/probe-protocol.md)");
  command->callback([&action] { action = run; });
}

}  // namespace plumb
