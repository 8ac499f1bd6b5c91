#include "conformance/verdict.h"

#include <algorithm>
#include <stdexcept>

namespace plumb {

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::quality_warning:
      return "quality_warning";
    case Verdict::fail:
      return "fail";
    case Verdict::timeout:
      return "timeout";
    case Verdict::memory_limit:
      return "memory_limit";
    case Verdict::output_limit:
      return "output_limit";
    case Verdict::crash:
      return "crash";
    case Verdict::security:
      return "security";
    case Verdict::unsupported:
      return "unsupported";
    case Verdict::skipped:
      return "skipped";
    case Verdict::internal_error:
      return "internal_error";
  }
  throw std::logic_error("unknown verdict");
}

bool is_right(Verdict verdict) { return verdict == Verdict::pass || verdict == Verdict::quality_warning; }

int exit_status(std::span<const Verdict> verdicts) {
  if (std::ranges::count(verdicts, Verdict::internal_error) > 0) return 3;
  return std::ranges::all_of(verdicts, is_right) ? 0 : 1;
}

}  // namespace plumb
