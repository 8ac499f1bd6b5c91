#include "conformance/subject/kernel_client.h"

#include <algorithm>
#include <array>

#include "renderer/math/input_error.h"

namespace plumb {
namespace {

constexpr std::uint64_t kHitBytes = 2 * sizeof(std::uint32_t) + 3 * sizeof(double);
/// Refusals, failures and facts.
constexpr std::uint64_t kMostText = 1 << 16;
constexpr std::uint64_t kMostListBytes = 1ull << 31;

/// The failures that a host tells of. What a kernel may have written over is not believed: anything else is fail with
/// `protocol`.
[[noreturn]] void throw_failure(KernelMessageReader message) {
  const std::string verdict = message.take_text();
  const std::string cause = message.take_text();
  const std::string sentence = message.take_text();
  message.expect_end();
  if (verdict == to_string(Verdict::crash) && cause == "overrun") throw SubjectFailure(Verdict::crash, cause, sentence);
  if (verdict == to_string(Verdict::fail) && (cause == "error" || cause == "protocol"))
    throw SubjectFailure(Verdict::fail, cause, sentence);
  throw KernelMessageFault("a failure that is none");
}

double primitives_of(const KernelScene& scene) {
  double sum = 0;
  for (const AskedSurface& surface : asked_surfaces(scene)) sum += static_cast<double>(surface.primitives);
  return sum;
}

}  // namespace

std::filesystem::path kernel_host_program() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "plumb-kernel-host";
}

KernelClient::KernelClient(const std::filesystem::path& library, const KernelOptions& options)
    : library_(std::filesystem::absolute(library)), options_(options), log_(options.log_bytes), facts_(start()) {}

KernelFacts KernelClient::start() {
  process_ = std::make_unique<KernelProcess>(options_.host, library_, options_.memory_bytes, log_);
  const KernelMessage message = process_->exchange({}, options_.seconds, kMostText);
  KernelMessageReader reader(message.bytes);
  try {
    if (message.word == KernelWord::refused) throw InputError({library_.string(), 0, 0}, reader.take_text());
    if (message.word != KernelWord::facts) throw KernelMessageFault("no facts");
    KernelFacts facts;
    facts.contract = reader.take<plumb_contract>();
    facts.name = reader.take_text();
    facts.description = reader.take_text();
    reader.expect_end();
    return facts;
  } catch (const KernelMessageFault& fault) {
    throw SubjectFailure(Verdict::fail, "protocol", fault.what());
  }
}

void KernelClient::ensure_started() {
  if (process_) return;
  if (!(start() == facts_))
    throw SubjectFailure(Verdict::fail, "protocol", "the kernel says something else of itself than the first time");
}

/// Generous: 0.1 ms a ray, 10 us a primitive to be built, and 20 ns for each pair of them, which a search without a
/// hierarchy needs.
double KernelClient::seconds_for(const Size& size) const {
  return options_.seconds + 1e-4 * size.rays + 1e-5 * size.primitives + 2e-8 * size.rays * size.primitives;
}

template <class Read>
auto KernelClient::ask(KernelMessageWriter& question, const Size& size, std::uint64_t most_bytes, Read read) {
  if (!process_) throw std::logic_error("no scene is loaded");
  try {
    const KernelMessage message =
        process_->exchange(question.finish(), seconds_for(size), std::max(most_bytes, kMostText));
    KernelMessageReader answer(message.bytes);
    if (message.word == KernelWord::failure) throw_failure(answer);
    if (message.word != KernelWord::answer) throw KernelMessageFault("what came from the kernel's host is no answer");
    auto result = read(answer);
    answer.expect_end();
    return result;
  } catch (const KernelMessageFault& fault) {
    throw SubjectFailure(Verdict::fail, "protocol", fault.what());
  }
}

void KernelClient::load(const KernelScene& scene) {
  ensure_started();
  primitives_ = primitives_of(scene);
  surfaces_ = scene.surfaces().size();
  KernelMessageWriter question(KernelWord::load);
  scene.write(question);
  ask(question, {0, primitives_}, 0, [](KernelMessageReader&) { return 0; });
}

RawHits KernelClient::closest(const KernelRays& rays) {
  const std::size_t count = rays.count();
  KernelMessageWriter question(KernelWord::closest);
  rays.write(question);
  return ask(question, {static_cast<double>(count), primitives_}, sizeof(double) + count * kHitBytes,
             [&](KernelMessageReader& answer) {
               cpu_seconds_ = answer.take<double>();
               return RawHits::read(answer, count);
             });
}

std::vector<std::uint8_t> KernelClient::any(const KernelRays& rays) {
  const std::size_t count = rays.count();
  KernelMessageWriter question(KernelWord::any);
  rays.write(question);
  return ask(question, {static_cast<double>(count), primitives_}, count,
             [&](KernelMessageReader& answer) { return answer.take_all<std::uint8_t>(count); });
}

RawLists KernelClient::all(const KernelRays& rays) {
  const std::size_t count = rays.count();
  KernelMessageWriter question(KernelWord::all);
  rays.write(question);
  return ask(question, {static_cast<double>(count), primitives_}, kMostListBytes, [&](KernelMessageReader& answer) {
    RawLists lists;
    const auto hits = answer.take<std::uint64_t>();
    lists.counts = answer.take_all<std::uint32_t>(count);
    lists.hits = RawHits::read(answer, hits);
    return lists;
  });
}

std::vector<double> KernelClient::bounds() {
  KernelMessageWriter question(KernelWord::bounds);
  return ask(question, {0, primitives_}, 6 * surfaces_ * sizeof(double),
             [&](KernelMessageReader& answer) { return answer.take_all<double>(6 * surfaces_); });
}

std::vector<RawHits> KernelClient::closest_each(std::span<const Question> questions) {
  ensure_started();
  KernelMessageWriter message(KernelWord::closest_each);
  message.put<std::uint64_t>(questions.size());
  Size size;
  std::uint64_t rays = 0;
  for (const Question& question : questions) {
    question.scene.write(message);
    question.rays.write(message);
    primitives_ = primitives_of(question.scene);
    surfaces_ = question.scene.surfaces().size();
    rays += question.rays.count();
    size = {size.rays + static_cast<double>(question.rays.count()), size.primitives + primitives_};
  }
  return ask(message, size, sizeof(double) + rays * kHitBytes, [&](KernelMessageReader& answer) {
    cpu_seconds_ = answer.take<double>();
    std::vector<RawHits> answers;
    answers.reserve(questions.size());
    for (const Question& question : questions) answers.push_back(RawHits::read(answer, question.rays.count()));
    return answers;
  });
}

}  // namespace plumb
