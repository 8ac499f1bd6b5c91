// spoiling_probe WAY ASK COMMAND...: a probe that hands each question on to another, COMMAND, and its answer back, but
// fails in its WAY where it is asked ASK: garbage, half-line, nan, crash, hang (without processor time) or burn.
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

constexpr const char* kLine = "PLUMB_PROBE_FD";

std::string read_line(int socket) {
  std::string line;
  char c = 0;
  while (::read(socket, &c, 1) == 1) {
    line += c;
    if (c == '\n') return line;
  }
  std::exit(0);  // the other side has gone
}

void write_text(int socket, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(socket, text.data() + done, text.size() - done);
    if (count <= 0) std::exit(1);
    done += static_cast<std::size_t>(count);
  }
}

/// The other probe, at the end of a new line.
int start(char** command) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) std::exit(1);
  if (::fork() == 0) {
    ::close(ends[0]);
    ::setenv(kLine, std::to_string(ends[1]).c_str(), 1);
    ::execv(command[0], command);
    ::_exit(127);
  }
  ::close(ends[1]);
  return ends[0];
}

/// The answer with its first number made NaN.
std::string with_nan(std::string answer) {
  const std::size_t list = answer.find('[');
  const std::size_t from = answer.find_first_of("-0123456789", list);
  const std::size_t to = answer.find_first_of(",]", from);
  return answer.replace(from, to - from, "\"nan\"");
}

std::string spoiled(const std::string& way, const std::string& answer) {
  if (way == "garbage") return "Hello, I am here!\n";
  if (way == "nan") return with_nan(answer);
  if (way == "crash") ::raise(SIGSEGV);
  if (way == "hang") ::sleep(1000);
  if (way == "burn")
    for (;;) ::getppid();
  return answer.substr(0, answer.size() / 2);  // half-line
}

}  // namespace

int main(int count, char** arguments) {
  const char* line = std::getenv(kLine);
  if (count < 4 || !line) return 2;
  const std::string way = arguments[1];
  const std::string word = "\"ask\":\"" + std::string(arguments[2]) + "\"";
  const int asks = std::atoi(line);
  const int other = start(arguments + 3);
  write_text(asks, read_line(other));
  for (;;) {
    const std::string question = read_line(asks);
    write_text(other, question);
    const std::string answer = read_line(other);
    const bool is_spoiled = question.find(word) != std::string::npos;
    write_text(asks, is_spoiled ? spoiled(way, answer) : answer);
    if (is_spoiled && way == "half-line") return 0;
  }
}
