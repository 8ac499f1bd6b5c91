#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "conformance/families/corpus.h"
#include "renderer/math/input_error.h"
#include "tools/plumb/arguments.h"
#include "tools/plumb/command.h"
#include "tools/plumb/progress_bar.h"

namespace plumb {
namespace {

struct Arguments {
  std::string family;
  std::int64_t count = 100'000;
  std::uint64_t seed = 1;
  std::string precision = "float";
  std::string out;
};

int run(const Arguments& arguments) {
  static constexpr std::array<std::string_view, 2> kPrecisions{"float", "double"};
  const CorpusRequest request{
      .family = &family_kind(arguments.family),
      .count = arguments.count,
      .seed = arguments.seed,
      .precision = parse_choice("--precision", arguments.precision, kPrecisions) == 0 ? PLUMB_FLOAT : PLUMB_DOUBLE};
  ProgressBar bar(arguments.family);
  const std::int64_t written = export_corpus(request, arguments.out, [&](double share) { bar.show(share); });
  fmt::print("{}: {} rays of {} ({}), seed {}\n", arguments.out, written, request.family->id, request.family->name,
             request.seed);
  return 0;
}

}  // namespace

void add_corpus_command(CLI::App& app, Action& action) {
  CLI::App* corpus = app.add_subcommand("corpus", "Certified rays and answers as a file, for kernels anywhere");
  corpus->require_subcommand(1);
  CLI::App* command =
      corpus->add_subcommand("export", "Write rays of a family with their exact answers (docs/corpus-format.md)");
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  command->add_option("--family", a.family, "A row of docs/hard-cases.md")->required()->type_name("ID");
  command->add_option("--count", a.count, "Rays [100000]")->check(CLI::PositiveNumber)->type_name("N");
  command->add_option("--seed", a.seed, "Same seed, same bytes [1]")->type_name("S");
  command->add_option("--precision", a.precision, "Of the inputs: float|double [float]")->type_name("P");
  command->add_option("--out", a.out, "The file")->required()->type_name("FILE");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace plumb
