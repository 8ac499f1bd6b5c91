#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/math/input_error.h"

namespace plumb {

/// The fields of one TOML table, read strictly: every error is an InputError at the value's line and column, and a key
/// that nobody asked for is one too (finish). The table must outlive this.
class TomlFields {
 public:
  /// `where` names the table in messages: `[suite]`.
  TomlFields(const toml::table& table, std::filesystem::path file, std::string where);

  std::string text(std::string_view key);
  std::string text(std::string_view key, std::string_view otherwise);
  bool flag(std::string_view key, bool otherwise);
  std::int64_t integer(std::string_view key, std::int64_t otherwise, std::int64_t least, std::int64_t most);
  /// Finite and at least `least`.
  double number(std::string_view key, double otherwise, double least);
  std::vector<std::string> texts(std::string_view key);
  std::vector<std::vector<std::string>> text_lists(std::string_view key);
  /// Names with texts, `{ NAME = "value" }`, in order of name.
  std::vector<std::pair<std::string, std::string>> text_table(std::string_view key);
  /// The tables of `[[key]]`, in order; each outlives this.
  std::vector<const toml::table*> tables(std::string_view key);
  bool has(std::string_view key) const;

  /// Throws at the first key that was not read above, with the nearest one that was.
  void finish() const;

  /// For the message of a missing key: a key that nobody asked for and that is spelt much like it, or nothing.
  std::string near_key(std::string_view key) const;
  SourceLocation where(std::string_view key) const;
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

 private:
  const toml::node* find(std::string_view key);
  std::string checked(const std::string& text, const toml::node& node) const;
  std::vector<std::string> texts_of(std::string_view key, const toml::node& node) const;

  const toml::table& table_;
  std::filesystem::path file_;
  std::string name_;
  std::set<std::string, std::less<>> known_;
};

/// Parses a TOML file. Throws InputError, with line and column, if it cannot be read or is malformed.
toml::table read_toml(const std::filesystem::path& file);

/// Where a node stands in its file.
SourceLocation location(const std::filesystem::path& file, const toml::node& node);

}  // namespace plumb
