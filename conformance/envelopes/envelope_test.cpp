#include "conformance/envelopes/envelope.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "conformance/envelopes/envelope_from_pictures.h"
#include "conformance/envelopes/judge_envelope.h"
#include "conformance/families/random.h"
#include "renderer/image/write_image.h"
#include "renderer/math/input_error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// 100 x 80, all interior, every level between 40 and 200, intervals of a single level.
Envelope plain_envelope() {
  Envelope e;
  e.width = 100, e.height = 80;
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x)
      for (int c = 0; c < 3; ++c) e.nominal.push_back(static_cast<std::uint8_t>(40 + (x + y + 30 * c) % 160));
  e.low = e.high = e.nominal;
  e.reasons.resize(8000);
  return e;
}

/// A vertical edge: column 50 may have any level.
Envelope edged_envelope() {
  Envelope e = plain_envelope();
  for (std::size_t y = 0; y < 80; ++y) {
    const std::size_t p = y * 100 + 50;
    e.reasons[p] = PixelReason::silhouette;
    for (std::size_t c = 3 * p; c < 3 * p + 3; ++c) e.low[c] = 0, e.high[c] = 255;
  }
  return e;
}

Picture picture_of(const Envelope& e) {
  Picture p;
  p.width = e.width, p.height = e.height;
  p.samples.assign(e.nominal.begin(), e.nominal.end());
  return p;
}

CheckResult judged(const Picture& picture, const Envelope& envelope) {
  return judge_findings(compare_with_envelope(picture, envelope, 1), picture, envelope, 1);
}

TEST(Envelope, IsTheSameAfterWritingAndReading) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("plumb-envelope-" + std::to_string(::getpid()));
  Envelope e = edged_envelope();
  e.guessed = true;
  write_envelope(e, folder);
  EXPECT_EQ(read_envelope(folder), e);
  EXPECT_NEAR(e.undecidable_share(), 0.01, 1e-15);
  e.guessed = false;
  write_envelope(e, folder);
  EXPECT_EQ(read_envelope(folder), e);
}

TEST(Envelope, ThatIsDamagedIsRefused) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("plumb-damaged-" + std::to_string(::getpid()));
  const Envelope e = edged_envelope();
  write_envelope(e, folder);
  fs::remove(folder / "high.png");
  EXPECT_THROW(read_envelope(folder), InputError);
  Envelope wrong = e;
  wrong.low[0] = 255;
  write_envelope(wrong, folder);
  EXPECT_THROW(read_envelope(folder), InputError);
  write_envelope(e, folder);
  write_png(std::vector<std::uint8_t>(12), 2, 2, folder / "low.png");
  EXPECT_THROW(read_envelope(folder), InputError);
  write_envelope(e, folder);
  write_png(std::vector<std::uint8_t>(24'000, 7), 100, 80, folder / "reasons.png");
  EXPECT_THROW(read_envelope(folder), InputError);
}

TEST(JudgeEnvelope, PassesTheReferenceAndWhatIsAllowed) {
  const Envelope e = edged_envelope();
  EXPECT_EQ(judged(picture_of(e), e).verdict, Verdict::pass);
  Picture p = picture_of(e);
  for (std::size_t y = 0; y < 80; ++y)
    for (std::size_t c = 0; c < 3; ++c) p.samples[3 * (100 * y + 50) + c] = y % 2 ? 0.0F : 255.0F;
  EXPECT_EQ(judged(p, e).verdict, Verdict::pass) << "a silhouette may fall to either side";
  Random random(1, "one-level", 0);
  int moved = 0;
  for (float& v : p.samples) {
    if (!random.one_in(3)) continue;
    v += random.coin() ? 1.0F : -1.0F;
    ++moved;
  }
  EXPECT_GT(moved, 5000);
  EXPECT_EQ(judged(p, e).verdict, Verdict::pass) << "a level either way is the tolerance";
}

TEST(JudgeEnvelope, CatchesTwoLevelsOverOnePercentOfTheInterior) {
  const Envelope e = edged_envelope();
  Picture p = picture_of(e);
  for (std::size_t i = 0; i < 80; ++i) p.samples[3 * (100 * i + 20) + 1] += 2;
  const CheckResult result = judged(p, e);
  EXPECT_EQ(result.verdict, Verdict::fail);
  EXPECT_EQ(result.cause, "different");
  EXPECT_EQ(result.margin, -1);
}

TEST(JudgeEnvelope, WarnsOfIsolatedPixelsAndFailsThoseThatTouch) {
  const Envelope e = plain_envelope();
  Picture p = picture_of(e);
  p.samples[3 * 1000] += 60, p.samples[3 * 2345] -= 30;
  EXPECT_EQ(judged(p, e).verdict, Verdict::quality_warning);
  EXPECT_EQ(judged(p, e).cause, "isolated_pixels");
  p.samples[3 * 1001] += 60;
  EXPECT_EQ(judged(p, e).verdict, Verdict::quality_warning);
  p.samples[3 * 2345] = e.nominal[3 * 2345];
  p.samples[3 * 1101] += 60;
  EXPECT_EQ(judged(p, e).verdict, Verdict::fail) << "three together";
  Picture four = picture_of(e);
  for (const std::size_t at : {100, 1050, 2345, 7000}) four.samples[3 * at] += 60;
  EXPECT_EQ(judged(four, e).verdict, Verdict::fail) << "four alone";
}

TEST(JudgeEnvelope, WarnsOfAOneSidedLevel) {
  const Envelope e = plain_envelope();
  Picture p = picture_of(e);
  for (std::size_t i = 0; i < p.samples.size(); i += 2) p.samples[i] -= 1;  // cut off in place of rounded
  const CheckResult result = judged(p, e);
  EXPECT_EQ(result.verdict, Verdict::quality_warning);
  EXPECT_EQ(result.cause, "bias");
}

TEST(JudgeEnvelope, OneSidedNoiseOfAFairProgramIsNoBias) {
  // 200 pictures whose samples are off by a level either way at random: none is taken for biased.
  const Envelope e = plain_envelope();
  int warned = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Picture p = picture_of(e);
    Random random(seed, "fair", 0);
    for (float& v : p.samples)
      if (random.one_in(4)) v += random.coin() ? 1.0F : -1.0F;
    warned += judged(p, e).verdict != Verdict::pass;
  }
  EXPECT_EQ(warned, 0);
}

TEST(EnvelopeFromPictures, OfSeveralIsTheirHull) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("plumb-several-" + std::to_string(::getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::vector<std::uint8_t> a(3 * 24, 100), b = a;
  b[0] = 101, b[3] = 140;
  write_png(a, 6, 4, folder / "a.png");
  write_png(b, 6, 4, folder / "b.png");
  const Envelope e = envelope_from_pictures(folder);
  EXPECT_TRUE(e.guessed);
  EXPECT_EQ(e.nominal, a);
  EXPECT_EQ(e.high[0], 101);
  EXPECT_EQ(e.reasons[0], PixelReason::interior);
  EXPECT_EQ(e.high[3], 140);
  EXPECT_EQ(e.reasons[1], PixelReason::silhouette);
  EXPECT_EQ(std::ranges::count(e.reasons, PixelReason::interior), 23);
}

TEST(EnvelopeFromPictures, OfOneAllowsItsEdges) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("plumb-one-" + std::to_string(::getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::vector<std::uint8_t> levels(3 * 60);
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = i / 3 % 10 < 5 ? 20 : 200;
  write_png(levels, 10, 6, folder / "right.png");
  const Envelope e = envelope_from_pictures(folder);
  EXPECT_EQ(std::ranges::count(e.reasons, PixelReason::silhouette), 12) << "the two columns beside the edge";
  EXPECT_EQ(e.low[3 * 5], 20);
  EXPECT_EQ(e.high[3 * 4], 200);
  EXPECT_EQ(e.high[3 * 3], 20);
  EXPECT_THROW(envelope_from_pictures(folder / "none"), InputError);
}

}  // namespace
}  // namespace plumb
