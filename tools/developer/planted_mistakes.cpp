#include "tools/developer/planted_mistakes.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>

#include "conformance/families/random.h"
#include "conformance/judge/toml_fields.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

std::vector<Edit> read_edits(const toml::array& list, const fs::path& file) {
  std::vector<Edit> edits;
  for (const toml::node& node : list) {
    const toml::table* table = node.as_table();
    if (!table) throw InputError(location(file, node), "'edit' holds no tables, expected [[edit]]");
    TomlFields edit(*table, file, "[[edit]]");
    edits.push_back({edit.text("file"), edit.text("find"), edit.text("replace")});
    edit.finish();
  }
  return edits;
}

PlantedMistake read_one(const fs::path& file) {
  toml::table table = read_toml(file);
  PlantedMistake mistake{file.stem().string(), {}, {}, {}};
  if (const toml::array* edits = table.get_as<toml::array>("edit")) mistake.edits = read_edits(*edits, file);
  if (mistake.edits.empty()) throw InputError({file.string()}, "changes nothing, expected tables [[edit]]");
  table.erase("edit");
  TomlFields fields(table, file, "the mistake");
  mistake.name = fields.text("name");
  mistake.same_as = fields.texts("same_as");
  fields.finish();
  return mistake;
}

bool share_a_name(const PlantedMistake& a, const PlantedMistake& b) {
  return std::ranges::any_of(a.same_as, [&](const std::string& id) { return std::ranges::count(b.same_as, id) > 0; });
}

}  // namespace

std::vector<PlantedMistake> read_planted_mistakes(const fs::path& folder) {
  std::vector<PlantedMistake> mistakes;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".toml") mistakes.push_back(read_one(entry.path()));
  if (mistakes.empty()) throw InputError({folder.string()}, "holds no mistake, expected files ID.toml");
  std::ranges::sort(mistakes, {}, &PlantedMistake::id);
  const std::string program = program_of(mistakes);
  for (const PlantedMistake& mistake : mistakes)
    for (const Edit& edit : mistake.edits)
      if (!edit.file.starts_with(program + "/"))
        throw InputError({(folder / (mistake.id + ".toml")).string()},
                         "changes " + edit.file + ", expected a file of " + program + " as the others");
  return mistakes;
}

std::string program_of(const std::vector<PlantedMistake>& mistakes) {
  const fs::path file = mistakes.at(0).edits.at(0).file;
  auto part = file.begin();
  const fs::path examples = *part;
  return (examples / *++part).generic_string();
}

std::string read_source(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError({file.string()}, "cannot be opened, expected a source of the program");
  return {std::istreambuf_iterator<char>(stream), {}};
}

SourceTree read_sources(const fs::path& root, const std::string& program) {
  SourceTree sources;
  if (fs::is_directory(root / program))
    for (const auto& entry : fs::recursive_directory_iterator(root / program))
      if (entry.is_regular_file())
        sources[entry.path().lexically_relative(root).generic_string()] = read_source(entry.path());
  if (sources.empty()) throw InputError({(root / program).string()}, "holds no files, expected a program");
  return sources;
}

SourceTree plant(const PlantedMistake& mistake, SourceTree sources) {
  for (const Edit& edit : mistake.edits) {
    const auto file = sources.find(edit.file);
    if (file == sources.end()) throw InputError({edit.file}, "is missing, expected a source for " + mistake.id);
    file->second = apply(edit, std::move(file->second));
  }
  return sources;
}

std::string in_single_precision(std::string text) {
  static const std::regex type("\\bdouble\\b"), least("std::max\\(0\\.0,"), most("std::min\\(1\\.0,"),
      offset("kEpsilon = 1e-6");
  text = std::regex_replace(text, type, "float");
  text = std::regex_replace(text, least, "std::max<float>(0,");
  text = std::regex_replace(text, most, "std::min<float>(1,");
  return std::regex_replace(text, offset, "kEpsilon = 1e-4");
}

std::vector<PlantedProgram> single_programs(const std::vector<PlantedMistake>& mistakes, const SourceTree& sources) {
  std::vector<PlantedProgram> programs;
  for (const PlantedMistake& mistake : mistakes) programs.push_back({mistake.id, plant(mistake, sources), {mistake}});
  return programs;
}

std::vector<PlantedProgram> pair_programs(const std::vector<PlantedMistake>& mistakes, const SourceTree& sources,
                                          std::size_t count, std::uint64_t seed) {
  std::vector<PlantedProgram> all;
  for (std::size_t i = 0; i < mistakes.size(); ++i)
    for (std::size_t k = i + 1; k < mistakes.size(); ++k) {
      const PlantedMistake &a = mistakes[i], &b = mistakes[k];
      if (a.same_as.empty() || b.same_as.empty() || share_a_name(a, b)) continue;
      try {
        all.push_back({a.id + "+" + b.id, plant(b, plant(a, sources)), {a, b}});
      } catch (const InputError&) {
        // The first changes the text that the second looks for.
      }
    }
  Random random(seed, "planted pairs", 0);
  for (std::size_t i = 0; i < std::min(count, all.size()); ++i)
    std::swap(all[i], all[i + random.below(static_cast<std::uint32_t>(all.size() - i))]);
  if (all.size() > count) all.resize(count);
  return all;
}

}  // namespace plumb
