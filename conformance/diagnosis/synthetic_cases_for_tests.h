#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "conformance/diagnosis/diagnose.h"

namespace plumb {

constexpr int kTestWidth = 64, kTestHeight = 48;
/// The line between two surfaces in each case: what is seen there is undecidable.
constexpr int kTestEdge = 40;

using Levels = std::vector<std::uint8_t>;
/// What is added to the level of a case's pixel.
using Change = std::function<int(const std::string& case_id, int x, int y)>;

inline int test_level(const std::string& case_id, int x, int y, int channel) {
  return 60 + x + y + 10 * channel + 5 * (case_id.front() - 'a') + (x >= kTestEdge ? 30 : 0);
}

inline Levels test_picture(const std::string& case_id, const Change& change) {
  Levels levels;
  for (int y = 0; y < kTestHeight; ++y)
    for (int x = 0; x < kTestWidth; ++x)
      for (int k = 0; k < 3; ++k)
        levels.push_back(
            static_cast<std::uint8_t>(std::clamp(test_level(case_id, x, y, k) + change(case_id, x, y), 0, 255)));
  return levels;
}

inline int no_change(const std::string&, int, int) { return 0; }

/// `amount` in a rectangle of one case.
inline Change patch(std::string case_id, int x0, int y0, int x1, int y1, int amount) {
  return [=](const std::string& id, int x, int y) {
    return id == case_id && x >= x0 && x < x1 && y >= y0 && y < y1 ? amount : 0;
  };
}

inline Change sum(Change a, Change b) {
  return
      [a = std::move(a), b = std::move(b)](const std::string& id, int x, int y) { return a(id, x, y) + b(id, x, y); };
}

/// Random bits of a pixel.
inline unsigned scrambled(unsigned seed, int x, int y) {
  unsigned v = seed * 2654435761u + static_cast<unsigned>(y * kTestWidth + x) * 2246822519u;
  v ^= v >> 15, v *= 2654435769u, v ^= v >> 13, v *= 3266489917u;
  return v ^ v >> 16;
}

/// `amount` in about one of `in` pixels of a rectangle.
inline Change speckles(unsigned seed, unsigned in, std::string case_id, int x0, int y0, int x1, int y1, int amount) {
  return [=, area = patch(std::move(case_id), x0, y0, x1, y1, amount)](const std::string& id, int x, int y) {
    return scrambled(seed, x, y) % in == 0 ? area(id, x, y) : 0;
  };
}

/// Four cases `a` to `d`, a submission's pictures of them, and known mistakes.
class SyntheticCases {
 public:
  explicit SyntheticCases(const Change& submission) {
    for (const std::string id : {"a", "b", "c", "d"}) {
      Envelope& envelope = envelopes_.emplace_back();
      envelope.width = kTestWidth, envelope.height = kTestHeight;
      envelope.nominal = envelope.low = envelope.high = test_picture(id, no_change);
      envelope.reasons.assign(static_cast<std::size_t>(kTestWidth * kTestHeight), PixelReason::interior);
      for (int y = 0; y < kTestHeight; ++y) {
        const auto pixel = static_cast<std::size_t>(y * kTestWidth + kTestEdge);
        envelope.reasons[pixel] = PixelReason::silhouette;
        for (std::size_t k = 0; k < 3; ++k)
          envelope.low[3 * pixel + k] = static_cast<std::uint8_t>(envelope.nominal[3 * pixel + k] - 31);
      }
      pictures_.push_back(test_picture(id, submission));
      cases.push_back({id, &envelope, 1, pictures_.back()});
    }
  }
  SyntheticCases(const SyntheticCases&) = delete;
  SyntheticCases& operator=(const SyntheticCases&) = delete;

  /// Has a picture of each case that the change shows in.
  void add_mistake(const std::string& id, const Change& change, std::vector<std::string> parts = {}) {
    Fingerprint f{id, "Mistake " + id, "Look at " + id + ".", "shaders", std::move(parts), {}, {}, false, {}};
    for (const DiagnosisCase& c : cases)
      if (const Levels levels = test_picture(c.id, change); levels != c.envelope->nominal)
        f.pictures.emplace(c.id, StoredPicture(levels, kTestWidth, kTestHeight));
    fingerprints.push_back(std::move(f));
  }

  Diagnosis diagnosis() const { return diagnose(cases, fingerprints); }

  std::vector<DiagnosisCase> cases;
  std::vector<Fingerprint> fingerprints;

 private:
  std::deque<Envelope> envelopes_;
  std::deque<Levels> pictures_;
};

}  // namespace plumb
