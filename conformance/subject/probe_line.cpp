#include "conformance/subject/probe_line.h"

#include <fmt/format.h>
#include <string.h>

#include <algorithm>

#include "conformance/subject/probe_numbers.h"
#include "conformance/subject/subject.h"

namespace plumb {
namespace {

using nlohmann::json;

constexpr double kSecondsToQuit = 1;
constexpr std::size_t kLongestLine = 256u << 20;
constexpr std::size_t kLongestGreeting = 1u << 20;
constexpr const char* kPrefix = "{\"plumb\":";

/// Whether the text holds, where JSON broke off, what programs print for a number that is none.
bool is_not_finite_at(std::string_view line, std::size_t byte) {
  const std::size_t begin = line.find_last_of(",:[ ", byte == 0 ? 0 : byte - 1);
  std::string word(line.substr(begin == std::string_view::npos ? 0 : begin + 1, 8));
  std::ranges::transform(word, word.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  const std::string_view unsigned_word = std::string_view(word).substr(word.starts_with('-') || word.starts_with('+'));
  return unsigned_word.starts_with("nan") || unsigned_word.starts_with("inf");
}

json parse(const std::string& line, std::string_view name) {
  try {
    return json::parse(line);
  } catch (const json::parse_error& error) {
    if (is_not_finite_at(line, error.byte))
      throw SubjectFailure(Verdict::fail, "not_finite", fmt::format("what came for {} holds NaN or an infinity", name));
    protocol_fault(fmt::format("what came for {} is not JSON at byte {}", name, error.byte));
  } catch (const json::out_of_range&) {  // 1e999
    throw SubjectFailure(Verdict::fail, "not_finite", fmt::format("what came for {} holds an infinite number", name));
  }
}

/// The failure that a run's end is.
SubjectFailure failure_of(const RunOutcome& outcome, const RunLimits& limits, std::string_view name) {
  switch (outcome.reason) {
    case StopReason::cpu_limit:
      return {Verdict::timeout, "cpu_time",
              fmt::format("more than {:g} s of processor time, at {}", limits.cpu_seconds, name)};
    case StopReason::wall_limit:
      return {Verdict::timeout, "wall_time", fmt::format("nothing in time for {}", name)};
    case StopReason::memory_limit:
      return {Verdict::memory_limit, "memory",
              fmt::format("more than {} MiB of memory, at {}", limits.memory_bytes >> 20, name)};
    case StopReason::process_limit:
      return {Verdict::memory_limit, "processes", fmt::format("too many processes and threads, at {}", name)};
    case StopReason::output_limit:
      return {Verdict::output_limit, "output_size",
              fmt::format("more than {} MiB written, at {}", limits.output_bytes >> 20, name)};
    case StopReason::interrupted:
      return {Verdict::skipped, "interrupted", "the check was interrupted"};
    case StopReason::cannot_start:
      return {Verdict::fail, "cannot_start", outcome.start_error};
    case StopReason::signalled:
      return {Verdict::crash, "signal", fmt::format("a signal ended it, number {}, at {}", outcome.signal, name)};
    case StopReason::exited:
      break;
  }
  if (outcome.exit_code != 0)
    return {Verdict::crash, "exit_status", fmt::format("it ended with exit status {} at {}", outcome.exit_code, name)};
  return {Verdict::fail, "protocol", fmt::format("it ended with nothing for {}", name)};
}

}  // namespace

ProbeLine::ProbeLine(const ProbeCommand& command) : limits_(command.limits) {
  session_.emplace(SessionRequest{.process = {.arguments = command.arguments,
                                              .folder = command.folder,
                                              .environment = command.environment,
                                              .writable_folder = {},
                                              .limits = command.limits},
                                  .line_variable = "PLUMB_PROBE_FD",
                                  .answer_prefix = kPrefix});
  greeting_ = exchange("", "the greeting", limits_.wall_seconds, kLongestGreeting);
}

ProbeLine::~ProbeLine() {
  if (!session_) return;
  try {
    session_->ask(fmt::format("{{\"id\":{},\"ask\":\"quit\"}}\n", last_id_ + 1), kSecondsToQuit, kLongestGreeting);
  } catch (const std::exception&) {  // It is ended all the same.
  }
}

json ProbeLine::ask(const ProbeQuestion& q) {
  const std::int64_t id = ++last_id_;
  const std::string text =
      fmt::format("{{\"id\":{},\"ask\":\"{}\"{}{}}}\n", id, q.ask, q.fields.empty() ? "" : ",", q.fields);
  const double seconds = limits_.wall_seconds + static_cast<double>(q.items) * q.seconds_an_item;
  const std::size_t longest = std::min(kLongestLine, kLongestGreeting + q.items * q.bytes_an_item);
  json answer = exchange(text, q.ask, seconds, longest);
  const json& answered = member(answer, "id", q.ask);
  if (!answered.is_number_integer() || answered != id)
    protocol_fault(fmt::format("the answer to {} has the id {}, expected {}", q.ask, shown(answered), id));
  if (const auto error = answer.find("error"); error != answer.end())
    throw SubjectFailure(Verdict::fail, "error",
                         fmt::format("to {} it said: {}", q.ask, sentence_of(*error, "an error")));
  if (const auto reason = answer.find("unsupported"); reason != answer.end())
    throw UnsupportedBySubject(fmt::format("{}: {}", q.ask, sentence_of(*reason, "the reason of unsupported")));
  member(answer, q.key, fmt::format("the answer to {}", q.ask));
  return std::move(answer[q.key]);
}

std::string ProbeLine::abandon() {
  if (!session_) return "";
  std::string log = session_->end().log;
  session_.reset();
  return log;
}

/// Sends the text, and reads one line with the version in it.
json ProbeLine::exchange(const std::string& text, std::string_view name, double seconds, std::size_t longest) {
  if (!session_) throw std::logic_error("ProbeLine: the program has been ended");
  const SessionAnswer answer = session_->ask(text, seconds, longest);
  if (answer.kind != SessionAnswer::Kind::line) fail(answer, name, seconds);
  json line = parse(answer.line, name);
  if (const json& version = member(line, "plumb", name); version != 1)
    protocol_fault(fmt::format("{} is of version {} of the protocol, expected 1", name, shown(version)));
  return line;
}

void ProbeLine::fail(const SessionAnswer& answer, std::string_view name, double seconds) {
  using Kind = SessionAnswer::Kind;
  if (answer.kind == Kind::too_late)
    throw SubjectFailure(Verdict::timeout, "wall_time",
                         fmt::format("nothing came for {} within {:g} s", name, seconds));
  if (answer.kind == Kind::too_long) protocol_fault(fmt::format("what came for {} is longer than allowed", name));
  if (answer.kind == Kind::closed) protocol_fault(fmt::format("it closed its line at {}", name));
  const bool in_line = answer.kind == Kind::half_line;
  if (in_line && !answer.ended) protocol_fault(fmt::format("it closed its line in the middle of {}", name));
  const SubjectFailure failure = failure_of(session_->end(answer.reason), limits_, name);
  if (in_line && failure.cause() == "protocol") protocol_fault(fmt::format("it ended in the middle of {}", name));
  throw failure;
}

}  // namespace plumb
