#include "conformance/judge/fingerprint_mutants.h"

#include <optional>
#include <stdexcept>

#include "conformance/compare/judge_picture.h"
#include "conformance/diagnosis/fingerprint.h"
#include "conformance/envelopes/judge_envelope.h"
#include "conformance/mutants/mutant.h"
#include "conformance/sandbox/run_process.h"
#include "conformance/sandbox/temporary_folder.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// What one program draws in one case: nothing usable, nothing wrong, or a wrong picture.
struct Drawing {
  bool usable = false;
  std::optional<Picture> wrong;
};

/// A case with its envelope, read once for all programs.
struct ReadCase {
  const SuiteCase& of;
  Picture reference;
  Envelope envelope;
};

Drawing draw(const fs::path& program, const ReadCase& read, const fs::path& folder) {
  const SuiteCase& c = read.of;
  const fs::path file = folder / "picture.png";
  ProcessRequest request;
  request.arguments = {program.string(), "render", c.scene.string(), "-o", file.string()};
  request.folder = folder;
  request.writable_folder = folder;
  request.limits = {.cpu_seconds = c.cpu_seconds,
                    .wall_seconds = c.wall_seconds,
                    .memory_bytes = c.memory_mb << 20,
                    .output_bytes = c.output_mb << 20};
  fs::remove(file);
  run_process(request);
  if (!fs::is_regular_file(file)) return {};
  PictureJudgement opened = open_picture(file, read.reference);
  if (opened.result.verdict != Verdict::pass) return {};
  if (compare_with_envelope(*opened.picture, read.envelope, c.tolerance).wrong_pixels() == 0)
    return {.usable = true, .wrong = {}};
  return {.usable = true, .wrong = std::move(opened.picture)};
}

/// What the mistake does to every picture alike, if it does; not where a case has none.
std::optional<PictureChange> change_of(const Fingerprint& fingerprint, const std::vector<ReadCase>& cases) {
  std::vector<std::vector<std::uint8_t>> levels;
  std::vector<DrawnCase> drawn;
  for (const ReadCase& c : cases) {
    const Envelope& e = c.envelope;
    const auto picture = fingerprint.pictures.find(c.of.id);
    levels.push_back(picture == fingerprint.pictures.end() ? e.nominal : picture->second.levels(e.width, e.height));
    drawn.push_back({e.nominal, {}, e.width, e.height});
  }
  for (std::size_t i = 0; i < cases.size(); ++i) drawn[i].drawn = levels[i];
  return find_picture_change(drawn);
}

Fingerprint fingerprint_of(const Mutant& mutant, const fs::path& program, const std::vector<ReadCase>& cases) {
  Fingerprint result;
  result.id = mutant.id, result.name = mutant.name, result.hint = mutant.hint, result.step = mutant.step;
  result.in_places = mutant.in_places;
  const TemporaryFolder folder("mistakes");
  for (const ReadCase& c : cases) {
    if (interrupt_flag()) break;
    const Drawing drawing = draw(program, c, folder.path());
    if (!drawing.usable) {
      result.no_picture.push_back(c.of.id);
    } else if (drawing.wrong) {
      const Picture& p = *drawing.wrong;
      std::vector<std::uint8_t> levels;
      for (const float v : p.samples) levels.push_back(static_cast<std::uint8_t>(v));
      result.pictures.emplace(c.of.id, StoredPicture(std::move(levels), p.width, p.height));
    }
  }
  if (result.no_picture.empty()) result.change = change_of(result, cases);
  return result;
}

}  // namespace

void require_mutants(const fs::path& programs, const fs::path& known_mistakes) {
  for (const Mutant& m : read_mutants(known_mistakes))
    if (!fs::is_regular_file(programs / m.id))
      throw InputError({(programs / m.id).string()},
                       "this program with a known mistake does not exist, expected what './dev mutants' builds");
}

int fingerprint_mutants(const FingerprintRequest& request) {
  require_mutants(request.programs, request.known_mistakes);
  const std::vector<Mutant> mutants = read_mutants(request.known_mistakes);
  std::vector<ReadCase> cases;
  for (const SuiteCase& c : request.cases)
    cases.push_back({c, read_reference(c.reference), read_envelope(c.envelopes.front())});
  int showing = 0;
  for (std::size_t i = 0; i < mutants.size() && !interrupt_flag(); ++i) {
    request.progress("known mistakes", static_cast<double>(i) / static_cast<double>(mutants.size()));
    const Fingerprint fingerprint = fingerprint_of(mutants[i], request.programs / mutants[i].id, cases);
    if (fingerprint.pictures.empty() && fingerprint.no_picture.empty()) continue;
    write_fingerprint(fingerprint, request.out / mutants[i].id);
    ++showing;
  }
  if (interrupt_flag()) throw std::runtime_error("interrupted");
  return showing;
}

}  // namespace plumb
