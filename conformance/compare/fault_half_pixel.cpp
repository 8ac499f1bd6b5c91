#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "conformance/compare/fault_search.h"

namespace plumb {
namespace {

// A picture that was shifted by half a pixel is no function of the reference, as it was sampled elsewhere. The
// reference shifted by the mean of neighbours is close to it, and how close is measured by the sum of squared
// differences. At a sharp edge without antialiasing, of contrast 1, an edge pixel of the shifted picture is another
// than the reference's every other time: 1/2 on average. Beside the mean it is off by 1/2 always: 1/4. Beside the mean
// to the other side: 1/4, and 1 every other time: 3/4. Antialiased edges and smooth shading are told far more clearly
// (1/5 and 0 of the unshifted sum). A picture that is antialiased where the reference is not: 1/12 unshifted and 5/24
// shifted, so it is no shift.

/// What remains of the unshifted sum: between the 1/2 of sharp edges and 1.
constexpr double kMostOfUnshifted = 0.7;
/// And of that to the other side: between 1/3 of sharp edges and 1. Taking means halves noise in the reference,
/// whatever the picture is, but does so to either side.
constexpr double kMostOfOpposite = 0.5;

/// Red, green and blue together.
std::vector<float> grey_of(const Picture& picture) {
  std::vector<float> grey(picture.samples.size() / 3);
  for (std::size_t i = 0; i < grey.size(); ++i)
    grey[i] = picture.samples[3 * i] + picture.samples[3 * i + 1] + picture.samples[3 * i + 2];
  return grey;
}

class ShiftedReference {
 public:
  explicit ShiftedReference(const FaultSearch& search)
      : width_(search.reference.width),
        height_(search.reference.height),
        reference_(grey_of(search.reference)),
        picture_(grey_of(search.picture)) {}

  /// The sum of squared differences to the reference shifted by (hx, hy) half pixels, each from -2 to 2, of all pixels
  /// but those at the border.
  double squares(int hx, int hy) const {
    // A shift by an odd number of halves is the mean of the two whole ones beside it.
    const std::ptrdiff_t x0 = hx / 2, x1 = hx - hx / 2, y0 = hy / 2, y1 = hy - hy / 2;
    double sum = 0;
    for (int y = 1; y < height_ - 1; ++y) {
      const float* const p = picture_.data() + static_cast<std::ptrdiff_t>(y) * width_;
      const float* const upper = reference_.data() + (y - y0) * width_;
      const float* const lower = reference_.data() + (y - y1) * width_;
      float row = 0;
      for (int x = 1; x < width_ - 1; ++x) {
        const float mean = 0.25F * ((upper[x - x0] + upper[x - x1]) + (lower[x - x0] + lower[x - x1]));
        row += (p[x] - mean) * (p[x] - mean);
      }
      sum += static_cast<double>(row);
    }
    return sum;
  }

 private:
  int width_, height_;
  std::vector<float> reference_, picture_;
};

std::string sentence_of(int hx, int hy) {
  std::string where;
  if (hx != 0) where = hx > 0 ? "to the right" : "to the left";
  if (hx != 0 && hy != 0) where += " and ";
  if (hy != 0) where += hy > 0 ? "downwards" : "upwards";
  return fmt::format("the whole picture is shifted by half a pixel {}: rays do not go through the pixels' centres",
                     where);
}

}  // namespace

void find_half_pixel_shift(const FaultSearch& search, std::vector<FoundFault>& found) {
  const int w = search.picture.width, h = search.picture.height;
  if (w < 3 || h < 3 || search.counts.in(1, 1, w - 1, h - 1) < kLeastWrongPixels) return;
  for (const FoundFault& fault : found)
    if (fault.fault == PictureFault::enlarged) return;  // the first pixel of a block lies off its middle
  const ShiftedReference shifted(search);
  std::array<std::array<double, 3>, 3> sums{};
  int best_x = 0, best_y = 0;
  const auto sum_at = [&](int hx, int hy) -> double& {
    return sums[static_cast<std::size_t>(hy + 1)][static_cast<std::size_t>(hx + 1)];
  };
  for (int hy = -1; hy <= 1; ++hy)
    for (int hx = -1; hx <= 1; ++hx) sum_at(hx, hy) = shifted.squares(hx, hy);
  for (int hy = -1; hy <= 1; ++hy)
    for (int hx = -1; hx <= 1; ++hx)
      if (sum_at(hx, hy) < sum_at(best_x, best_y)) best_x = hx, best_y = hy;
  const double best = sum_at(best_x, best_y), unshifted = sum_at(0, 0);
  if ((best_x == 0 && best_y == 0) || best > kMostOfUnshifted * unshifted) return;
  if (best > kMostOfOpposite * sum_at(-best_x, -best_y)) return;
  if (best > kMostOfUnshifted * shifted.squares(2 * best_x, 2 * best_y)) return;  // a whole pixel fits as well
  found.push_back({PictureFault::half_pixel_shift, sentence_of(best_x, best_y), 1 - best / unshifted});
}

}  // namespace plumb
