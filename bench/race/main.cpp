// The race against the peers: `plumb_bench [--filter REGEX] [--rounds N] [--rays N] [--json FILE]`. Google Benchmark
// names the rows, chooses among them and writes the JSON; a row interleaves its contestants itself (rows.h).
#include <benchmark/benchmark.h>

#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "bench/race/race_meshes.h"
#include "bench/race/race_tables.h"
#include "bench/race/rows.h"

namespace {

using namespace plumb::bench;

constexpr const char* kUsage = R"(usage: plumb_bench [--filter REGEX] [--rounds N] [--rays N] [--json FILE]
  --filter REGEX  only the rows that it is found in, as trace/bunny69k/primary   [all]
  --rounds N      how often each contestant has its turn                         [7]
  --rays N        rays of a set                                                  [131072]
  --json FILE     write the numbers of all rows to a file
The tables are trace, batch, build, threads, growth and frame; options of Google Benchmark are taken too.
)";

template <class Number>
bool read_number(const char* text, Number& number) {
  const char* end = text + std::strlen(text);
  const auto [stop, fault] = std::from_chars(text, end, number);
  return fault == std::errc() && stop == end && number >= 1;
}

/// Our options, and the rest as Google Benchmark takes them. False where an argument is wrong.
bool read_arguments(int argc, char** argv, RaceSize& size, std::vector<std::string>& rest) {
  rest.emplace_back(argv[0]);
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool has_value = i + 1 < argc;
    if (argument == "--filter" && has_value) {
      rest.push_back("--benchmark_filter=" + std::string(argv[++i]));
    } else if (argument == "--json" && has_value) {
      rest.push_back("--benchmark_out=" + std::string(argv[++i]));
      rest.emplace_back("--benchmark_out_format=json");
    } else if (argument == "--rounds" && has_value) {
      if (!read_number(argv[++i], size.rounds)) return false;
    } else if (argument == "--rays" && has_value) {
      if (!read_number(argv[++i], size.rays)) return false;
    } else if (argument.starts_with("--benchmark_")) {
      rest.push_back(argument);
    } else {
      return false;
    }
  }
  return true;
}

/// Rows of one mesh are neighbours, because its contestants are made once.
void register_rows(const RaceSize& size) {
  const std::vector<std::string> meshes = race_mesh_names();
  for (const std::string& mesh : meshes) {
    register_trace_rows({mesh}, size);
    register_batch_rows({mesh}, size);
    register_thread_rows({mesh}, size);
  }
  register_build_rows(meshes, size);
  register_growth_rows(size);
  register_frame_row(size);
}

int run(std::vector<std::string>& arguments) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;
  for (const PeerKind& kind : peer_kinds()) benchmark::AddCustomContext(kind.name, kind.description);
  benchmark::AddCustomContext("flags", PLUMB_BUILD_FLAGS);
  RaceTables tables;
  if (benchmark::RunSpecifiedBenchmarks(&tables) == 0) return 2;
  return tables.failed() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) try {
  RaceSize size;
  std::vector<std::string> rest;
  if (!read_arguments(argc, argv, size, rest)) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  register_rows(size);
  return run(rest);
} catch (const std::exception& fault) {
  std::fprintf(stderr, "plumb_bench: %s\n", fault.what());
  return 2;
}
