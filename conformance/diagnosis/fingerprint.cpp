#include "conformance/diagnosis/fingerprint.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "conformance/compare/judge_picture.h"
#include "renderer/image/staged_file.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kSchema = 2;

constexpr std::array<std::string_view, 4> kMoves{"none", "left-right", "top-bottom", "red-blue"};

Json to_json(const PictureChange& change) {
  return {{"move", kMoves.at(static_cast<std::size_t>(change.move))}, {"table", change.table}};
}

PictureChange picture_change(const Json& json, const fs::path& file) {
  const auto name = json.at("move").get<std::string>();
  const auto move = std::ranges::find(kMoves, name);
  if (move == kMoves.end())
    throw InputError({file.string()},
                     fmt::format("change.move is '{}', expected one of {}", name, fmt::join(kMoves, ", ")));
  return {static_cast<PictureChange::Move>(move - kMoves.begin()),
          json.at("table").get<std::array<std::uint8_t, 256>>()};
}

Json parse(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError({file.string()}, "cannot be opened, expected the description of a known mistake");
  try {
    return Json::parse(stream);
  } catch (const nlohmann::json::exception& error) {
    throw InputError({file.string()}, fmt::format("is no JSON: {}", error.what()));
  }
}

}  // namespace

std::vector<std::uint8_t> StoredPicture::levels(int width, int height) const {
  const auto check_size = [&](int w, int h) {
    if (w != width || h != height)
      throw InputError({file_.string()},
                       fmt::format("is {}x{}, expected {}x{} as the case's envelope", w, h, width, height));
  };
  if (file_.empty()) {
    check_size(width_, height_);
    return levels_;
  }
  const Picture picture = read_reference(file_);
  if (picture.is_linear()) throw InputError({file_.string()}, "holds linear colours, expected 8-bit levels");
  check_size(picture.width, picture.height);
  std::vector<std::uint8_t> levels(picture.samples.size());
  std::ranges::transform(picture.samples, levels.begin(), [](float v) { return static_cast<std::uint8_t>(v); });
  return levels;
}

void StoredPicture::write(const fs::path& file) const {
  if (file_.empty())
    write_png(levels_, width_, height_, file);
  else if (!fs::exists(file) || !fs::equivalent(file_, file))
    fs::copy_file(file_, file, fs::copy_options::overwrite_existing);
}

void write_fingerprint(const Fingerprint& fingerprint, const fs::path& folder) {
  fs::create_directories(folder);
  Json cases = Json::array();
  for (const auto& [id, picture] : fingerprint.pictures) {
    picture.write(folder / (id + ".png"));
    cases.push_back(id);
  }
  Json json;
  json["schema"] = kSchema;
  json["name"] = fingerprint.name;
  json["hint"] = fingerprint.hint;
  json["step"] = fingerprint.step;
  json["parts"] = fingerprint.parts;
  json["cases"] = cases;
  json["no_picture"] = fingerprint.no_picture;
  json["in_places"] = fingerprint.in_places;
  if (fingerprint.change) json["change"] = to_json(*fingerprint.change);
  write_file_staged(folder / "mistake.json", json.dump(2) + "\n");
}

Fingerprint read_fingerprint(const fs::path& folder) {
  const fs::path file = folder / "mistake.json";
  const Json json = parse(file);
  Fingerprint fingerprint;
  fingerprint.id = folder.filename().string();
  try {
    if (const int schema = json.at("schema").get<int>(); schema != kSchema)
      throw InputError({file.string()}, fmt::format("has the schema {}, expected {}", schema, kSchema));
    fingerprint.name = json.at("name").get<std::string>();
    fingerprint.hint = json.at("hint").get<std::string>();
    fingerprint.step = json.at("step").get<std::string>();
    fingerprint.parts = json.at("parts").get<std::vector<std::string>>();
    fingerprint.no_picture = json.at("no_picture").get<std::vector<std::string>>();
    fingerprint.in_places = json.at("in_places").get<bool>();
    if (json.contains("change")) fingerprint.change = picture_change(json.at("change"), file);
    for (const auto& id : json.at("cases").get<std::vector<std::string>>())
      fingerprint.pictures.emplace(id, StoredPicture(folder / (id + ".png")));
  } catch (const nlohmann::json::exception& error) {
    throw InputError({file.string()}, fmt::format("is no description of a known mistake: {}", error.what()));
  }
  return fingerprint;
}

std::vector<Fingerprint> read_fingerprints(const fs::path& folder) {
  std::vector<Fingerprint> fingerprints;
  if (!fs::exists(folder)) return fingerprints;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) fingerprints.push_back(read_fingerprint(entry.path()));
  std::ranges::sort(fingerprints, {}, &Fingerprint::id);
  return fingerprints;
}

}  // namespace plumb
