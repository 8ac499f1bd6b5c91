#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "conformance/diagnosis/deviation.h"

namespace plumb {

/// One mistake, case by case in the order of the submission's deviations.
struct MistakeMatches {
  /// Nothing where the mistake draws the case rightly.
  std::vector<std::optional<Match>> cases;
  /// Cases that are left out, as nobody knows what a program with the mistake draws there.
  std::vector<bool> unknown;
  /// Whether the mistake shows only here and there, nobody knows where.
  bool in_places = false;
};

/// One case's part in a likeness.
struct CaseLikeness {
  /// 0 where neither pattern shows, or nobody knows.
  double weight = 0;
  double value = 0;
  /// Numbers of pixels: where the submission is wrong; where the mistakes show; where they agree with it; where they
  /// show and it is right.
  std::int64_t wrong = 0, shown = 0, agreed = 0, missed = 0;
};

/// How far one mistake, or two together, accounts for a submission.
struct Likeness {
  /// In [0, 1]: the mean over the cases of three likenesses of their patterns; 1 if all are the same.
  double value = 0;
  /// Of the submission's wrong pixels, over all cases: the share that is reproduced.
  double explained = 0;
  /// Of the pixels where the mistakes show, over all cases: the share in which the submission is right.
  double missed = 0;
  std::vector<CaseLikeness> cases;
};

/// Compares over all cases at once. A case counts by the share of its pixels that are wrong in either pattern, up to
/// about a half percent; from there on a large pattern counts little more than a small one, so that no case drowns the
/// others. In a case,
/// - half of the likeness is the area where colours agree, as a share of the area where either pattern shows [Jaccard
///   1912];
/// - a quarter compares what the pictures are off by in squares of 8 x 8 pixels, as the sum of the smaller over that of
///   the larger amounts [Ruzicka 1958]: two programs have different noise, but as much of it;
/// - a quarter is the cosine between those sums: the same mistake with another constant goes into the same direction.
/// Of a mistake that shows in places nothing counts but the share of the submission's wrong area that agrees, and that
/// by four fifths: a picture that is wrong everywhere agrees with something more easily.
Likeness likeness(std::span<const Deviation> deviations, const MistakeMatches& mistake);

/// The same of two mistakes together, of which `a_alone` and `b_alone` are the likenesses. Nothing is drawn for it:
/// colours agree where either mistake agrees; where both show and neither agrees, the area counts half. Their amounts
/// are those of the sum, or of one where it hides the other.
Likeness likeness_together(std::span<const Deviation> deviations, const MistakeMatches& a, const Likeness& a_alone,
                           const MistakeMatches& b, const Likeness& b_alone);

}  // namespace plumb
