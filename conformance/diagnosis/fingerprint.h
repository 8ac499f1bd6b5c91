#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "conformance/diagnosis/picture_change.h"

namespace plumb {

/// A picture that is decoded when it is asked for: a PNG file, or 8-bit levels in memory.
class StoredPicture {
 public:
  explicit StoredPicture(std::filesystem::path file) : file_(std::move(file)) {}
  /// Three bytes a pixel, rows from the top.
  StoredPicture(std::vector<std::uint8_t> levels, int width, int height)
      : levels_(std::move(levels)), width_(width), height_(height) {}

  /// Three bytes a pixel, rows from the top. Throws InputError, naming the file, if it is missing, no picture of 8-bit
  /// levels, or not of this size.
  std::vector<std::uint8_t> levels(int width, int height) const;
  /// Writes the PNG file, or copies the one that this stands for.
  void write(const std::filesystem::path& file) const;

 private:
  std::filesystem::path file_;
  std::vector<std::uint8_t> levels_;
  int width_ = 0, height_ = 0;
};

/// What a program with one known mistake, or with a named pair of them, draws in each case of a suite where it shows.
struct Fingerprint {
  std::string id;
  /// What a student would call the mistake.
  std::string name;
  /// What a teacher would say about it.
  std::string hint;
  /// The step of the assignment that it belongs to.
  std::string step;
  /// Of a pair: the ids of its two mistakes. Empty for a single one.
  std::vector<std::string> parts;
  /// By case id. A case that is in neither list is drawn rightly.
  std::map<std::string, StoredPicture> pictures;
  /// The cases for which nothing usable is written (a crash, no end): not compared.
  std::vector<std::string> no_picture;
  /// Whether a program with the mistake shows it only here and there, and the pictures show it everywhere.
  bool in_places = false;
  /// Where the mistake does the same to every picture.
  std::optional<PictureChange> change;
};

/// Writes `mistake.json` and one `CASE.png` for each picture into the folder, which is made. The same fingerprint gives
/// the same bytes.
void write_fingerprint(const Fingerprint& fingerprint, const std::filesystem::path& folder);

/// Reads what write_fingerprint wrote; the folder's name is the id, and pictures are not decoded. Throws InputError,
/// naming the file, if `mistake.json` is missing or malformed.
Fingerprint read_fingerprint(const std::filesystem::path& folder);

/// All fingerprints of a folder, in order of id; none if the folder does not exist.
std::vector<Fingerprint> read_fingerprints(const std::filesystem::path& folder);

}  // namespace plumb
