#pragma once

#include "conformance/judge/suite.h"
#include "conformance/results/result_set.h"
#include "conformance/results/write_results.h"

namespace plumb {

/// Looks for the known mistakes that account for the wrong pictures of a submission that was judged by envelopes, over
/// all its cases at once: the suite's fingerprints, and what a picture as a whole shows (mirrored, shifted, without
/// gamma). Sets `diagnosis` if a picture is wrong and the suite has fingerprints. Pictures are those kept in the
/// results.
void diagnose_results(const Suite& suite, const ResultFolder& folder, ResultSet& results);

}  // namespace plumb
