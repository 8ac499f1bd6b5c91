#include "conformance/judge/toml_fields.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include "renderer/math/nearest_name.h"

namespace plumb {
namespace {

std::string in_quotes(std::string_view word) { return "'" + std::string(word) + "'"; }

}  // namespace

toml::table read_toml(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError({file.string()}, "this is a folder, expected a TOML file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError({file.string()}, std::string("cannot open the file: ") + std::strerror(errno));
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& parse_error) {
    const toml::source_position at = parse_error.source().begin;
    throw InputError({file.string(), static_cast<int>(at.line), static_cast<int>(at.column)},
                     "malformed TOML: " + std::string(parse_error.description()));
  }
}

SourceLocation location(const std::filesystem::path& file, const toml::node& node) {
  const toml::source_position at = node.source().begin;
  return {file.string(), static_cast<int>(at.line), static_cast<int>(at.column)};
}

TomlFields::TomlFields(const toml::table& table, std::filesystem::path file, std::string where)
    : table_(table), file_(std::move(file)), name_(std::move(where)) {}

bool TomlFields::has(std::string_view key) const { return table_.contains(key); }

const toml::node* TomlFields::find(std::string_view key) {
  known_.emplace(key);
  return table_.get(key);
}

SourceLocation TomlFields::where(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return location(file_, node ? *node : table_);
}

void TomlFields::fail(std::string_view key, const std::string& what) const {
  throw InputError(where(key), in_quotes(key) + " of " + name_ + " " + what);
}

std::string TomlFields::text(std::string_view key) {
  if (!find(key)) fail(key, "is missing, expected a text" + near_key(key));
  return text(key, "");
}

std::string TomlFields::text(std::string_view key, std::string_view otherwise) {
  const toml::node* node = find(key);
  if (!node) return std::string(otherwise);
  if (!node->is_string()) fail(key, "is no text, expected \"...\"");
  return checked(node->as_string()->get(), *node);
}

std::string TomlFields::near_key(std::string_view key) const {
  std::vector<std::string_view> keys;
  for (const auto& [other, node] : table_)
    if (!known_.contains(other.str())) keys.push_back(other.str());
  const std::string_view nearest = nearest_name(key, keys);
  return nearest.empty() ? "" : "; is '" + std::string(nearest) + "' a misspelling of it?";
}

bool TomlFields::flag(std::string_view key, bool otherwise) {
  const toml::node* node = find(key);
  if (!node) return otherwise;
  if (!node->is_boolean()) fail(key, "is neither true nor false");
  return node->as_boolean()->get();
}

std::int64_t TomlFields::integer(std::string_view key, std::int64_t otherwise, std::int64_t least, std::int64_t most) {
  const toml::node* node = find(key);
  if (!node) return otherwise;
  if (!node->is_integer() || node->as_integer()->get() < least || node->as_integer()->get() > most) {
    fail(key, "is not a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return node->as_integer()->get();
}

double TomlFields::number(std::string_view key, double otherwise, double least) {
  const toml::node* node = find(key);
  if (!node) return otherwise;
  const std::optional<double> value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value) || *value < least)
    fail(key, "is not a number of at least " + std::to_string(least));
  return *value;
}

std::string TomlFields::checked(const std::string& text, const toml::node& node) const {
  if (text.find('\0') != std::string::npos)
    throw InputError(location(file_, node), "this text holds a zero byte, which no command or file name can");
  return text;
}

std::vector<std::string> TomlFields::texts_of(std::string_view key, const toml::node& node) const {
  const toml::array* array = node.as_array();
  if (!array) fail(key, "is no list, expected [\"...\", \"...\"]");
  std::vector<std::string> texts;
  for (const toml::node& item : *array) {
    if (!item.is_string())
      throw InputError(location(file_, item), "an item of " + in_quotes(key) + " is no text, expected \"...\"");
    texts.push_back(checked(item.as_string()->get(), item));
  }
  return texts;
}

std::vector<std::string> TomlFields::texts(std::string_view key) {
  const toml::node* node = find(key);
  return node ? texts_of(key, *node) : std::vector<std::string>{};
}

std::vector<std::vector<std::string>> TomlFields::text_lists(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return {};
  const toml::array* array = node->as_array();
  if (!array) fail(key, "is no list of lists, expected [[\"program\", \"argument\"]]");
  std::vector<std::vector<std::string>> lists;
  for (const toml::node& item : *array) {
    if (!item.is_array())
      throw InputError(
          location(file_, item),
          "an item of " + in_quotes(key) + " is no list, expected [\"program\", \"argument\"]; there is no shell");
    lists.push_back(texts_of(key, item));
  }
  return lists;
}

std::vector<std::pair<std::string, std::string>> TomlFields::text_table(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return {};
  const toml::table* table = node->as_table();
  if (!table) fail(key, "is no table, expected { NAME = \"value\" }");
  std::vector<std::pair<std::string, std::string>> entries;
  for (const auto& [name, value] : *table) {
    if (!value.is_string())
      throw InputError(location(file_, value), in_quotes(name.str()) + " is no text, expected \"...\"");
    entries.emplace_back(name.str(), checked(value.as_string()->get(), value));
  }
  return entries;
}

std::vector<const toml::table*> TomlFields::tables(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return {};
  if (!node->is_array_of_tables()) fail(key, "is no list of tables, expected [[" + std::string(key) + "]]");
  std::vector<const toml::table*> tables;
  for (const toml::node& item : *node->as_array()) tables.push_back(item.as_table());
  return tables;
}

void TomlFields::finish() const {
  const std::vector<std::string_view> names(known_.begin(), known_.end());
  for (const auto& [key, node] : table_) {
    if (known_.contains(key.str())) continue;
    std::string expected;
    for (const std::string_view name : names) expected += (expected.empty() ? "" : ", ") + std::string(name);
    throw InputError(location(file_, node), "unknown key " + in_quotes(key.str()) + " in " + name_ + ", expected " +
                                                expected + did_you_mean(key.str(), names));
  }
}

}  // namespace plumb
