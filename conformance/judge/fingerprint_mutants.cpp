#include "conformance/judge/fingerprint_mutants.h"

#include <stdlib.h>

#include <cerrno>
#include <optional>
#include <system_error>

#include "conformance/compare/judge_picture.h"
#include "conformance/diagnosis/fingerprint.h"
#include "conformance/envelopes/judge_envelope.h"
#include "conformance/mutants/mutant.h"
#include "conformance/sandbox/run_process.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// A folder that is gone when this is.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "plumb-mistakes-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), "cannot make " + name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// What one program draws in one case: nothing usable, nothing wrong, or a wrong picture.
struct Drawing {
  bool usable = false;
  std::optional<Picture> wrong;
};

Drawing draw(const fs::path& program, const SuiteCase& c, const fs::path& folder) {
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
  PictureJudgement opened = open_picture(file, read_reference(c.reference));
  if (opened.result.verdict != Verdict::pass) return {};
  const Envelope envelope = read_envelope(c.envelopes.front());
  if (compare_with_envelope(*opened.picture, envelope, c.tolerance).wrong_pixels() == 0) return {.usable = true, .wrong = {}};
  return {.usable = true, .wrong = std::move(opened.picture)};
}

Fingerprint fingerprint_of(const Mutant& mutant, const FingerprintRequest& request) {
  Fingerprint result;
  result.id = mutant.id, result.name = mutant.name, result.hint = mutant.hint, result.step = mutant.step;
  const TemporaryFolder folder;
  for (const SuiteCase& c : request.cases) {
    if (interrupt_flag()) break;
    const Drawing drawing = draw(request.programs / mutant.id, c, folder.path());
    if (!drawing.usable) {
      result.no_picture.push_back(c.id);
    } else if (drawing.wrong) {
      const Picture& p = *drawing.wrong;
      std::vector<std::uint8_t> levels;
      for (const float v : p.samples) levels.push_back(static_cast<std::uint8_t>(v));
      result.pictures.emplace(c.id, StoredPicture(std::move(levels), p.width, p.height));
    }
  }
  return result;
}

}  // namespace

int fingerprint_mutants(const FingerprintRequest& request) {
  const std::vector<Mutant> mutants = read_mutants(request.known_mistakes);
  for (const Mutant& m : mutants)
    if (!fs::is_regular_file(request.programs / m.id))
      throw InputError({(request.programs / m.id).string()},
                       "this program with a known mistake does not exist, expected what './dev mutants' builds");
  // One after the other: a process can watch over a single run at a time.
  int showing = 0, done = 0;
  for (const Mutant& mutant : mutants) {
    const Fingerprint fingerprint = fingerprint_of(mutant, request);
    const bool shows = !fingerprint.pictures.empty() || !fingerprint.no_picture.empty();
    if (shows) write_fingerprint(fingerprint, request.out / mutant.id);
    showing += shows;
    request.progress("known mistakes", ++done / static_cast<double>(mutants.size()));
  }
  return showing;
}

}  // namespace plumb
