#include "conformance/mutants/mutant.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>

#include "conformance/judge/toml_fields.h"
#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::string in_quotes(std::string_view word) { return "'" + std::string(word) + "'"; }

/// One line of a text that may have many, for a message.
std::string beginning(const std::string& text) {
  const std::size_t start = std::min(text.find_first_not_of(" \n"), text.size());
  const std::size_t end = std::min(text.find('\n', start), text.size());
  return text.substr(start, std::min<std::size_t>(end - start, 80));
}

std::string filled_text(TomlFields& fields, std::string_view key) {
  std::string text = fields.text(key);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) fields.fail(key, "is empty, expected a text");
  return text;
}

void check_step(const TomlFields& fields, const std::string& step) {
  if (std::ranges::find(mutant_steps(), step) != mutant_steps().end()) return;
  std::string steps;
  for (const std::string_view known : mutant_steps()) steps += (steps.empty() ? "" : ", ") + std::string(known);
  fields.fail("step", "is " + in_quotes(step) + ", expected one of " + steps + did_you_mean(step, mutant_steps()));
}

Edit read_edit(TomlFields& fields) {
  Edit edit{filled_text(fields, "file"), filled_text(fields, "find"), fields.text("replace")};
  // Every file that includes a header would have to be compiled again.
  if (!edit.file.ends_with(".cpp"))
    fields.fail("file", "is " + in_quotes(edit.file) + ", expected a .cpp file, which is compiled by itself");
  if (edit.find == edit.replace) fields.fail("replace", "is what it replaces, expected a change");
  return edit;
}

/// The edit of the table itself, and those of its `[[edit]]` tables.
std::vector<Edit> read_edits(TomlFields& fields, const toml::table& table, const fs::path& file) {
  std::vector<Edit> edits;
  if (fields.has("file")) edits.push_back(read_edit(fields));
  for (const toml::table* each : fields.tables("edit")) {
    TomlFields of_edit(*each, file, "[[edit]]");
    edits.push_back(read_edit(of_edit));
    of_edit.finish();
  }
  if (edits.empty())
    throw InputError(location(file, table), "the mutant changes nothing, expected file, find and replace");
  return edits;
}

void check_reason(const Mutant& mutant, const TomlFields& fields) {
  if (mutant.caught_by.empty() && mutant.accepted.empty() && mutant.equivalent.empty())
    fields.fail("caught_by", "names nothing, expected a case or check:ID, or one of accepted and equivalent");
  if (!mutant.accepted.empty() && !mutant.equivalent.empty())
    fields.fail("equivalent", "is given beside 'accepted', expected one of them");
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) throw InputError({file.string()}, "cannot read the source that a mutant changes");
  return text;
}

void check_unique(std::map<std::string, std::string>& known, const std::string& text, std::string_view what,
                  const Mutant& mutant) {
  const auto [entry, is_new] = known.emplace(text, mutant.id);
  if (!is_new) {
    throw InputError({mutant.id + ".toml"}, "its " + std::string(what) + " is also that of " + entry->second +
                                                ", expected another: '" + text + "'");
  }
}

}  // namespace

std::vector<std::string> Mutant::files() const {
  std::vector<std::string> files;
  for (const Edit& edit : edits)
    if (std::ranges::find(files, edit.file) == files.end()) files.push_back(edit.file);
  return files;
}

std::span<const std::string_view> mutant_steps() {
  static constexpr std::array<std::string_view, 13> kSteps{
      "camera",     "surfaces",  "lights",    "shaders",      "boxes", "mesh",  "groups",
      "transforms", "hierarchy", "recursion", "antialiasing", "gamma", "parser"};
  return kSteps;
}

Mutant read_mutant(const fs::path& file) {
  const toml::table table = read_toml(file);
  TomlFields fields(table, file, "the mutant");
  Mutant mutant;
  mutant.id = file.stem().string();
  mutant.name = filled_text(fields, "name");
  mutant.hint = filled_text(fields, "hint");
  mutant.step = filled_text(fields, "step");
  check_step(fields, mutant.step);
  mutant.in_places = fields.flag("in_places", false);
  mutant.edits = read_edits(fields, table, file);
  mutant.caught_by = fields.texts("caught_by");
  mutant.accepted = fields.text("accepted", "");
  mutant.equivalent = fields.text("equivalent", "");
  check_reason(mutant, fields);
  fields.finish();
  return mutant;
}

std::vector<Mutant> read_mutants(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  if (files.empty()) throw InputError({folder.string()}, "the folder holds no mutant, expected files ID.toml");
  std::ranges::sort(files);
  std::vector<Mutant> mutants;
  std::map<std::string, std::string> names, hints;
  for (const fs::path& file : files) {
    mutants.push_back(read_mutant(file));
    check_unique(names, mutants.back().name, "name", mutants.back());
    check_unique(hints, mutants.back().hint, "hint", mutants.back());
  }
  return mutants;
}

std::string apply(const Edit& edit, std::string text) {
  const std::size_t at = text.find(edit.find);
  if (at == std::string::npos) {
    throw InputError({edit.file}, "the text that a mutant replaces does not occur, expected it exactly once: '" +
                                      beginning(edit.find) + "'");
  }
  if (text.find(edit.find, at + 1) != std::string::npos) {
    throw InputError({edit.file}, "the text that a mutant replaces occurs more than once, expected it exactly once: '" +
                                      beginning(edit.find) + "'");
  }
  return text.replace(at, edit.find.size(), edit.replace);
}

std::string mutated_source(const Mutant& mutant, std::string_view file, const fs::path& root) {
  std::string text = text_of(root / file);
  for (const Edit& edit : mutant.edits)
    if (edit.file == file) text = apply(edit, std::move(text));
  return text;
}

}  // namespace plumb
