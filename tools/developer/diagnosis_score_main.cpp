// Diagnoses programs with planted mistakes by what a built suite knows, and prints how often that is right, for
// docs/diagnosis.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "tools/developer/diagnosis_score.h"

namespace {

void print(const char* what, const plumb::Rate& rate) {
  if (rate.tries == 0) return;
  fmt::print("| {} | {} of {} | {:.0f} % | {:.0f} to {:.0f} % |\n", what, rate.hits, rate.tries,
             100 * static_cast<double>(rate.hits) / static_cast<double>(rate.tries), 100 * rate.low(),
             100 * rate.high());
}

void print(const plumb::DiagnosisOutcome& outcome) {
  fmt::print("{}{}{}{}\n", outcome.label, outcome.shows ? "" : " (does not show)",
             outcome.first_right   ? ": right"
             : outcome.three_right ? ": among three"
                                   : ": not found",
             outcome.diagnosis.confident ? ", confident" : "");
  for (const plumb::Suspicion& s : outcome.diagnosis.suspicions) {
    fmt::print("    {:.3f} explained {:.2f} missed {:.2f} {}", s.likeness, s.explained, s.missed, s.id);
    for (const std::string& other : s.or_one_of) fmt::print(" | {}", other);
    fmt::print("\n");
  }
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Scores the diagnosis on programs whose mistakes are known");
  std::filesystem::path built, wrong;
  int tolerance = 1;
  bool verbose = false;
  app.add_option("built", built, "A built suite: envelopes/CASE/ and fingerprints/ID/")->required();
  app.add_option("wrong", wrong, "Pictures: LABEL/CASE.png and LABEL/expected")->required();
  app.add_option("--tolerance", tolerance, "Levels beyond the envelope that count as right")->capture_default_str();
  app.add_flag("--verbose", verbose, "Prints each program's list");
  CLI11_PARSE(app, argc, argv);

  const plumb::DiagnosisScore score =
      plumb::score_diagnosis(plumb::read_knowledge(built), plumb::read_planted_pictures(wrong), tolerance);
  if (verbose)
    for (const plumb::DiagnosisOutcome& outcome : score.outcomes) print(outcome);
  fmt::print("| of the programs in which it shows | | | 95 % interval |\n| --- | --- | --- | --- |\n");
  print("single mistake: first suspicion right", score.first);
  print("single mistake: among the first three", score.three);
  print("single mistake: confident", score.confident);
  print("any: confidently wrong", score.confidently_wrong);
  print("pair: both named first", score.both_named);
  print("pair: one named, nothing wrong", score.one_named);
  print("mistake that is not known: kept open", score.unknown_kept_open);
  print("right program: any suspicion", score.false_alarms);
  fmt::print("\nmost CPU time of one diagnosis: {:.2f} s\n", score.most_cpu_seconds);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 2;
}
