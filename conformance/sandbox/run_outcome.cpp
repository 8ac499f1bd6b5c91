#include "conformance/sandbox/run_outcome.h"

namespace plumb {

const char* to_string(StopReason reason) {
  switch (reason) {
    case StopReason::exited:
      return "exited";
    case StopReason::signalled:
      return "signalled";
    case StopReason::cpu_limit:
      return "cpu_limit";
    case StopReason::wall_limit:
      return "wall_limit";
    case StopReason::memory_limit:
      return "memory_limit";
    case StopReason::output_limit:
      return "output_limit";
    case StopReason::cannot_start:
      return "cannot_start";
    case StopReason::interrupted:
      return "interrupted";
    case StopReason::process_limit:
      return "process_limit";
  }
  return "?";
}

}  // namespace plumb
