// Judges folders of pictures by a built suite's envelopes, one line a folder (docs/envelopes.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>

#include "conformance/judge/suite.h"
#include "tools/developer/judge_pictures.h"

namespace fs = std::filesystem;

namespace {

/// `cause: CASE CASE`, for each cause of a verdict that is not `pass`.
std::string remarks(const plumb::JudgedPictures& pictures) {
  std::map<std::string, std::string> cases;
  for (const plumb::JudgedPicture& p : pictures.cases)
    if (p.result.verdict != plumb::Verdict::pass) cases[p.result.cause] += " " + p.id;
  for (const std::string& id : pictures.unusable) cases["no picture"] += " " + id;
  std::string text;
  for (const auto& [cause, ids] : cases) text += (text.empty() ? "" : "; ") + cause + ":" + ids;
  return text;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Judges the pictures FOLDER/CASE.png by a built suite; the exit status is 1 if any pixel is wrong");
  fs::path built;
  std::vector<fs::path> folders;
  bool verbose = false;
  app.add_option("built", built, "A suite that was built")->required()->check(CLI::ExistingDirectory);
  app.add_option("folders", folders, "Folders of pictures")->required()->check(CLI::ExistingDirectory);
  app.add_flag("--verbose", verbose, "Also what each wrong picture has");
  CLI11_PARSE(app, argc, argv);

  const plumb::Suite suite = plumb::read_suite(built / "suite.toml");
  fmt::print("{:<32} {:<18} {:>8} {:>6} {:>6}  {}\n", "program", "variant", "pictures", "wrong", "moved", "remarks");
  bool right = true;
  for (const fs::path& folder : folders) {
    const plumb::JudgedPictures p = plumb::judge_pictures(suite, folder);
    const std::string name = fs::weakly_canonical(folder).filename().string();
    fmt::print("{:<32} {:<18} {:>8} {:>6} {:>6}  {}\n", name, p.variant, p.cases.size(), p.wrong_pixels(),
               p.moved_pixels(), remarks(p));
    right = right && p.wrong_pixels() == 0 && p.unusable.empty() && !p.cases.empty();
    for (const plumb::JudgedPicture& c : p.cases)
      if (verbose && c.wrong_pixels > 0) fmt::print("  {}: {}; {}\n", c.id, c.result.summary, c.result.advice);
  }
  return right ? 0 : 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 2;
}
