#include "conformance/subject/kernel_host.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <optional>

#include "conformance/sandbox/file_descriptor.h"
#include "conformance/subject/kernel_caller.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

/// The other end is gone, and with it the reason to go on.
struct LineClosed {};

void read_all(int descriptor, void* to, std::size_t count) {
  auto* next = static_cast<char*>(to);
  while (count > 0) {
    const ssize_t got = ::read(descriptor, next, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw LineClosed();
    next += got;
    count -= static_cast<std::size_t>(got);
  }
}

void send_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) throw LineClosed();
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
}

/// Moves the line out of the way of a library that reads or closes what it takes for its own, such as descriptor 0.
FileDescriptor moved_away(int descriptor) {
  constexpr int kFarFromOthers = 100;
  FileDescriptor line(::fcntl(descriptor, F_DUPFD_CLOEXEC, kFarFromOthers));
  if (!line.valid()) return FileDescriptor(descriptor);
  ::close(descriptor);
  if (descriptor == 0 && ::open("/dev/null", O_RDONLY) != 0) throw LineClosed();
  return line;
}

void put_lists(KernelMessageWriter& answer, const RawLists& lists) {
  answer.put<std::uint64_t>(lists.hits.count());
  answer.put_all(lists.counts);
  lists.hits.write(answer);
}

void put_each(KernelMessageWriter& answer, KernelCaller& kernel, KernelMessageReader& question) {
  const auto count = question.take<std::uint64_t>();
  std::vector<RawKernel::Question> questions;
  for (std::uint64_t i = 0; i < count; ++i) {
    KernelScene scene = KernelScene::read(question);
    questions.push_back({std::move(scene), KernelRays::read(question)});
  }
  const std::vector<RawHits> answers = kernel.closest_each(questions);
  answer.put(kernel.cpu_seconds());
  for (const RawHits& hits : answers) hits.write(answer);
}

void put_answer(KernelMessageWriter& answer, KernelCaller& kernel, KernelWord word, KernelMessageReader& question) {
  switch (word) {
    case KernelWord::load:
      return kernel.load(KernelScene::read(question));
    case KernelWord::closest: {
      const RawHits hits = kernel.closest(KernelRays::read(question));
      answer.put(kernel.cpu_seconds());
      return hits.write(answer);
    }
    case KernelWord::closest_each:
      return put_each(answer, kernel, question);
    case KernelWord::any:
      return answer.put_all(kernel.any(KernelRays::read(question)));
    case KernelWord::all:
      return put_lists(answer, kernel.all(KernelRays::read(question)));
    case KernelWord::bounds:
      return answer.put_all(kernel.bounds());
    default:
      throw KernelMessageFault("no question");
  }
}

/// Reads one question and answers it.
void serve(KernelCaller& kernel, int line) {
  KernelMessageHead head;
  read_all(line, &head, sizeof head);
  if (head.magic != KernelMessageHead::kMagic) throw KernelMessageFault("no message");
  std::vector<std::byte> bytes(head.bytes);
  read_all(line, bytes.data(), bytes.size());
  KernelMessageReader question(bytes);
  KernelMessageWriter answer(KernelWord::answer);
  try {
    put_answer(answer, kernel, head.word, question);
  } catch (const SubjectFailure& failure) {
    answer = KernelMessageWriter(KernelWord::failure);
    answer.put_text(to_string(failure.verdict()));
    answer.put_text(failure.cause());
    answer.put_text(failure.what());
  }
  std::fflush(nullptr);  // what the kernel printed belongs to this question
  send_all(line, answer.finish());
}

/// A crash shall end the process with its signal, also where a sanitizer has put a handler that exits instead.
void let_signals_end_the_process() {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, SIG_DFL);
}

std::optional<KernelCaller> loaded(const std::filesystem::path& library, int line) {
  try {
    return std::optional<KernelCaller>(std::in_place, library);
  } catch (const InputError& error) {
    KernelMessageWriter refusal(KernelWord::refused);
    // The place is the library, which whoever asked adds again.
    const std::string text = error.what();
    const std::string place = to_string(error.where()) + ": ";
    refusal.put_text(text.starts_with(place) ? text.substr(place.size()) : text);
    send_all(line, refusal.finish());
    return std::nullopt;
  }
}

}  // namespace

int run_kernel_host(const std::filesystem::path& library, int descriptor) {
  try {
    let_signals_end_the_process();
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const FileDescriptor line = moved_away(descriptor);
    std::optional<KernelCaller> kernel = loaded(library, line.get());
    if (!kernel) return 0;
    KernelMessageWriter facts(KernelWord::facts);
    facts.put(kernel->facts().contract);
    facts.put_text(kernel->facts().name);
    facts.put_text(kernel->facts().description);
    send_all(line.get(), facts.finish());
    for (;;) serve(*kernel, line.get());
  } catch (const LineClosed&) {
    return 0;
  }
}

}  // namespace plumb
