#include "bench/race/race_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "bench/peers/peer.h"
#include "bench/race/rows.h"

namespace plumb::bench {
namespace {

using Run = benchmark::BenchmarkReporter::Run;

/// NaN where the row has no such number.
double number(const Run& run, const std::string& counter) {
  const auto found = run.counters.find(counter);
  return found == run.counters.end() ? std::numeric_limits<double>::quiet_NaN() : found->second.value;
}

/// `format` of the value, or a dash, in a column of eleven.
void print_cell(const char* format, double value) {
  char text[32] = "-";
  if (!std::isnan(value)) std::snprintf(text, sizeof text, format, value);
  std::printf(" %11s", text);
}

/// Two numbers in such a column.
void print_pair(const char* format, double first, double second) {
  char text[32] = "-";
  if (!std::isnan(first)) std::snprintf(text, sizeof text, format, first, second);
  std::printf(" %11s", text);
}

/// Three digits that count, from 0.00123 to 12300.
void print_ratio(double ratio) { print_cell(ratio < 0.095 ? "%.3g" : "%.2f", ratio); }

/// The name after the table's: mesh, and rays if there are any.
std::string subject(const Run& run) {
  const std::string& name = run.run_name.function_name;
  return name.substr(name.find('/') + 1);
}

/// The contestants with such a counter in any of the rows, in the order of the roster; `batches` first if asked.
std::vector<std::string> columns(const std::vector<const Run*>& rows, std::string_view counter, bool batches_first) {
  std::vector<std::string> names;
  for (const bool batches : {batches_first, !batches_first}) {
    for (const PeerKind& kind : peer_kinds()) {
      const bool used =
          std::ranges::any_of(rows, [&](const Run* run) { return run->counters.contains(of(counter, kind.name)); });
      if (used && kind.batches == batches) names.push_back(kind.name);
    }
  }
  return names;
}

void print_head(const std::string& first, const std::vector<std::string>& names) {
  std::printf("%-22s", first.c_str());
  for (const std::string& name : names) std::printf(" %11s", name.c_str());
  std::printf("\n");
}

}  // namespace

bool RaceTables::ReportContext(const Context&) { return true; }

void RaceTables::ReportRuns(const std::vector<Run>& report) {
  for (const Run& run : report) {
    failed_ = failed_ || run.error_occurred;
    if (run.error_occurred) std::fprintf(stderr, "%s: %s\n", run.benchmark_name().c_str(), run.error_message.c_str());
    std::fprintf(stderr, "%s\n", run.run_name.function_name.c_str());
    runs_.push_back(run);
  }
}

std::vector<const Run*> RaceTables::of_table(const std::string& table) const {
  std::vector<const Run*> found;
  for (const Run& run : runs_)
    if (run.run_name.function_name.starts_with(table + "/")) found.push_back(&run);
  return found;
}

void RaceTables::print_speeds(const std::string& table) const {
  const auto rows = of_table(table);
  if (rows.empty()) return;
  std::vector<std::string> names = columns(rows, kRatio, table == kBatch);
  const std::string first = names.front();
  names.front() += " M/s";
  std::printf("\n%s: million rays a second of %s; the others' speed as a ratio to it\n",
              table == kTrace ? "Single-ray calls" : "Batches, beside single-ray calls", first.c_str());
  print_head("mesh/rays", names);
  names.front() = first;
  for (const Run* run : rows) {
    std::printf("%-22s", subject(*run).c_str());
    print_cell("%.2f", number(*run, of(kSpeed, first)));
    for (std::size_t i = 1; i < names.size(); ++i) print_ratio(number(*run, of(kRatio, names[i])));
    std::printf("\n");
  }
}

void RaceTables::print_differences() const {
  const auto rows = of_table(kTrace);
  if (rows.empty()) return;
  const auto names = columns(rows, kDiffers, false);
  std::printf(
      "\nAnswers that differ from the exact ones of %s, ties apart, in %% of the rays that were asked; and of these "
      "the\n"
      "rays that go through a surface\n",
      std::string(kJudge).c_str());
  std::vector<std::string> head{"rays", "hits %"};
  head.insert(head.end(), names.begin(), names.end());
  print_head("mesh/rays", head);
  for (const Run* run : rows) {
    std::printf("%-22s", subject(*run).c_str());
    print_cell("%.0f", number(*run, "rays"));
    print_cell("%.1f", 100 * number(*run, "hits"));
    for (const std::string& name : names)
      print_pair("%.3g %.3g", 100 * number(*run, of(kDiffers, name)), 100 * number(*run, of(kEscapes, name)));
    std::printf("\n");
  }
}

void RaceTables::print_builds() const {
  const auto rows = of_table(kBuild);
  if (rows.empty()) return;
  std::printf(
      "\nBuilds by one and by two threads: milliseconds of the process's CPU time, of the calling thread's and of "
      "wall\n"
      "time; bytes of positions, indices and hierarchy\n");
  print_head("mesh", {"peer", "cpu 1", "to embree", "cpu 2", "caller 2", "wall 1", "wall 2", "to embree", "bytes/tri"});
  for (const Run* run : rows) {
    for (const std::string& name : columns({run}, kCpu1, false)) {
      std::printf("%-22s %11s", subject(*run).c_str(), name.c_str());
      const auto ms = [&](const char* what) { print_cell("%.1f", number(*run, of(what, name))); };
      const auto ratio = [&](const char* what) {
        print_cell("%.2f", number(*run, of(what, name)) / number(*run, of(what, peer_kinds()[0].name)));
      };
      ms(kCpu1), ratio(kCpu1), ms(kCpu2), ms(kCaller2), ms(kWall1), ms(kWall2), ratio(kWall2), ms(kBytes);
      std::printf("\n");
    }
  }
}

void RaceTables::print_scaling() const {
  const auto rows = of_table(kThreads);
  if (rows.empty()) return;
  const auto names = columns(rows, kScaling, false);
  std::printf("\nTwo threads: wall time of one by that of two, and the same by CPU time of the slower one\n");
  print_head("mesh/rays", names);
  for (const Run* run : rows) {
    std::printf("%-22s", subject(*run).c_str());
    for (const std::string& name : names)
      print_pair("%.2f %.2f", number(*run, of(kScaling, name)), number(*run, of(kCpuScaling, name)));
    std::printf("\n");
  }
}

void RaceTables::print_growth() const {
  for (const Run* run : of_table(kGrowth)) {
    const auto key = [](const std::string& peer) { return of(kNanoseconds, peer) + " at "; };
    std::set<std::size_t> sizes;
    const std::string first = key(peer_kinds()[0].name);
    for (const auto& [name, counter] : run->counters)
      if (name.starts_with(first)) sizes.insert(std::stoul(name.substr(first.size())));
    if (sizes.empty()) continue;
    std::printf("\nGrowth: nanoseconds of a primary ray by the number of triangles, and the last by the first\n");
    std::vector<std::string> head;
    for (const std::size_t size : sizes) head.push_back(std::to_string(size));
    head.push_back("growth");
    print_head("peer", head);
    for (const PeerKind& kind : peer_kinds()) {
      const auto at = [&](std::size_t size) { return number(*run, key(kind.name) + std::to_string(size)); };
      if (std::isnan(at(*sizes.begin()))) continue;
      std::printf("%-22s", kind.name.c_str());
      for (const std::size_t size : sizes) print_cell("%.1f", at(size));
      print_cell("%.2f", at(*sizes.rbegin()) / at(*sizes.begin()));
      std::printf("\n");
    }
  }
}

void RaceTables::print_frame() const {
  for (const Run* run : of_table(kFrameTable)) {
    if (run->error_occurred) continue;
    std::printf("\nA frame of %.0f triangles, 640 x 480, from text, one thread: CPU seconds of the process\n",
                number(*run, "triangles"));
    std::printf("POV-Ray 3.7 as Debian builds it, +WT1: %.3f; plumb render --threads 1: %.3f; %.2f times faster\n",
                number(*run, of(kFrame, "povray")), number(*run, of(kFrame, "plumb")),
                number(*run, of(kRatio, "plumb")));
    std::printf("Pixels that differ by more than 8 levels of 255: %.0f\n", number(*run, "other pixels"));
  }
}

void RaceTables::Finalize() {
  for (const PeerKind& kind : peer_kinds()) std::printf("%-12s %s\n", kind.name.c_str(), kind.description.c_str());
  std::printf("ours         %s\n", PLUMB_BUILD_FLAGS);
  print_speeds(kTrace);
  print_differences();
  print_speeds(kBatch);
  print_builds();
  print_scaling();
  print_growth();
  print_frame();
}

}  // namespace plumb::bench
