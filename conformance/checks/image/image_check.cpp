#include "conformance/checks/image/image_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "conformance/compare/flip.h"
#include "conformance/compare/heat_map.h"
#include "conformance/compare/judge_picture.h"
#include "conformance/envelopes/envelope.h"
#include "conformance/envelopes/judge_envelope.h"
#include "conformance/judge/copy_tree.h"
#include "conformance/judge/suite_hash.h"
#include "conformance/sandbox/harvest.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

CheckResult result_of(Verdict verdict, const std::string& cause, const std::string& summary,
                      const std::string& advice) {
  CheckResult result;
  result.verdict = verdict;
  result.cause = cause;
  result.summary = summary;
  result.advice = advice;
  return result;
}

/// The pictures that the program wrote somewhere else, by name; at most three. Links are not followed.
std::string pictures_elsewhere(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error);
       !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    if (!it->is_symlink() && it->is_regular_file(error) && is_picture(it->path()))
      names.push_back("'" + it->path().lexically_relative(folder).generic_string() + "'");
  }
  std::ranges::sort(names);
  if (names.size() > 3) names.resize(3);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? ", but there is " : ", ") + name;
  return text;
}

CheckResult no_picture(const ImageCheckInput& input) {
  std::string summary = fmt::format("there is no picture '{}'{}", input.output, pictures_elsewhere(input.run_folder));
  std::string advice = "read log.txt for what the program said, and check where it writes its picture";
  if (input.run.reason == StopReason::cannot_start)
    advice =
        "is it executable (chmod +x)? a script's first line must name a program that is there, without Windows line "
        "ends";
  if (input.run.reason == StopReason::cannot_start)
    summary = input.run.start_error;
  else if (input.run.exit_code != 0)
    summary += fmt::format("; the program ended with exit status {}", input.run.exit_code);
  CheckResult result = result_of(Verdict::fail, "no_picture", summary, advice);
  result.evidence = {{"exit_code", std::int64_t{input.run.exit_code}}};
  return result;
}

CheckResult unusable(const HarvestResult& harvested) {
  switch (harvested.status) {
    case HarvestStatus::link:
      return result_of(Verdict::security, "link", harvested.sentence,
                       "the picture must be an ordinary file, not a link");
    case HarvestStatus::too_large:
      return result_of(Verdict::output_limit, "output_size", harvested.sentence, "write only the picture");
    case HarvestStatus::not_regular:
      return result_of(Verdict::fail, "bad_picture", harvested.sentence, "the picture must be an ordinary file");
    case HarvestStatus::missing:
    case HarvestStatus::copied:
      break;
  }
  throw std::logic_error("this harvest is not unusable");
}

void judge_by_reference(const ImageCheckInput& input, const fs::path& file, ImageCheck& check) {
  const Picture reference = read_reference(input.suite_case.reference);
  const PictureJudgement judgement = judge_picture(file, reference, input.suite_case.tolerance);
  check.result = judgement.result;
  if (judgement.difference && judgement.difference->max > 0)
    write_png(heat_map(reference, *judgement.picture), reference.width, reference.height,
              input.evidence_folder / "difference.png");
}

/// The heat map of the wrong pixels alone: those that are a right answer count as equal.
void write_wrong_pixels(const Picture& reference, Picture picture, const PixelMask& mask, const fs::path& file) {
  for (std::size_t i = 0; i < picture.samples.size(); ++i)
    if (mask.wrong[i / 3] == 0) picture.samples[i] = reference.samples[i];
  write_png(heat_map(reference, picture), reference.width, reference.height, file);
}

/// For people: how visible the difference is, and where most of it lies. They decide nothing.
void add_metrics(const Picture& nominal, const Picture& picture, const WrongRegions& regions, CheckResult& result) {
  const FlipErrors errors = flip(nominal, picture);
  const WrongRegion& window = regions.densest_window;
  result.evidence.insert(result.evidence.end(), {{"flip_mean", errors.mean},
                                                 {"flip_p99", errors.p99},
                                                 {"densest_window_x", std::int64_t{window.x}},
                                                 {"densest_window_y", std::int64_t{window.y}},
                                                 {"densest_window_wrong", window.wrong}});
}

Picture nominal_picture(const Envelope& envelope) {
  Picture picture;
  picture.width = envelope.width, picture.height = envelope.height;
  picture.samples.assign(envelope.nominal.begin(), envelope.nominal.end());
  return picture;
}

void judge_by_envelopes(const ImageCheckInput& input, const fs::path& file, ImageCheck& check) {
  const SuiteCase& c = input.suite_case;
  Envelope envelope = read_envelope(c.envelopes.front());
  const PictureJudgement opened = open_picture(file, nominal_picture(envelope));
  check.result = opened.result;
  if (check.result.verdict != Verdict::pass) return;
  std::optional<EnvelopeFindings> best;
  Picture best_reference;
  for (std::size_t v = 0; v < c.envelopes.size(); ++v) {
    const auto same =
        std::ranges::find(c.envelopes.begin(), c.envelopes.begin() + static_cast<std::ptrdiff_t>(v), c.envelopes[v]);
    if (const auto earlier = static_cast<std::size_t>(same - c.envelopes.begin()); earlier < v) {
      check.by_variant.push_back(check.by_variant[earlier]);
      continue;
    }
    if (v > 0) envelope = read_envelope(c.envelopes[v]);
    EnvelopeFindings findings = compare_with_envelope(*opened.picture, envelope, c.tolerance);
    check.by_variant.push_back(judge_findings(findings, *opened.picture, envelope, c.tolerance));
    if (!is_right(check.by_variant.back().verdict))
      add_metrics(nominal_picture(envelope), *opened.picture, findings.regions, check.by_variant.back());
    if (!best || findings.wrong_pixels() < best->wrong_pixels()) {
      check.result = check.by_variant.back();
      if (findings.wrong_pixels() > 0) best_reference = nominal_picture(envelope);
      best = std::move(findings);
    }
  }
  if (best->wrong_pixels() > 0)
    write_wrong_pixels(best_reference, *opened.picture, best->mask, input.evidence_folder / "difference.png");
}

void warn_of_exit_status(int exit_code, CheckResult& result) {
  if (!is_right(result.verdict)) return;
  result.verdict = Verdict::quality_warning;
  result.cause = "exit_status";
  result.advice = fmt::format("the picture is right, but the program ended with exit status {}: end with 0", exit_code);
}

}  // namespace

ImageCheck check_image(const ImageCheckInput& input) {
  ImageCheck check;
  const fs::path reference_copy =
      input.evidence_folder / ("reference" + input.suite_case.reference.extension().string());
  fs::copy_file(input.suite_case.reference, reference_copy, fs::copy_options::overwrite_existing);
  check.hashes.emplace_back("reference", file_hash(reference_copy));

  const fs::path picture = input.evidence_folder / ("picture" + fs::path(input.output).extension().string());
  const HarvestResult harvested = harvest(input.run_folder, input.output, input.suite_case.output_mb << 20, picture);
  if (harvested.status == HarvestStatus::missing) {
    check.result = no_picture(input);
    return check;
  }
  if (harvested.status != HarvestStatus::copied) {
    check.result = unusable(harvested);
    return check;
  }
  check.hashes.emplace_back("picture", file_hash(picture));

  if (input.suite_case.envelopes.empty())
    judge_by_reference(input, picture, check);
  else
    judge_by_envelopes(input, picture, check);
  if (input.run.exit_code != 0) {
    warn_of_exit_status(input.run.exit_code, check.result);
    for (CheckResult& result : check.by_variant) warn_of_exit_status(input.run.exit_code, result);
  }
  return check;
}

}  // namespace plumb
