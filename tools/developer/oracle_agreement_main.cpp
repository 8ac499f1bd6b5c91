// Holds the oracle's independent ways against each other, family by family, and prints a table for docs/oracle.md.
#include <fmt/format.h>

#include <cstdlib>

#include "tools/developer/oracle_agreement.h"

namespace {

std::int64_t all_cases = 0, all_disagreements = 0;

void print(const plumb::OracleAgreement& a) {
  all_cases += a.cases;
  all_disagreements += a.disagreements;
  fmt::print("| {} | {} | {} | {:.2f} % |{}\n", a.family, a.cases, a.disagreements,
             100 * static_cast<double>(a.undecided) / static_cast<double>(a.cases),
             a.first.empty() ? "" : " " + a.first);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t count = argc > 1 ? std::atoll(argv[1]) : 36'000;
  fmt::print("| family | cases | disagreements | undecided by the filter |\n| --- | --- | --- | --- |\n");
  for (const plumb::FamilyKind* family : plumb::family_kinds())
    // A ray at a mesh is as many questions as the mesh has triangles.
    print(plumb::agree_on_rays(*family, family->id == "T12" ? std::min<std::int64_t>(count, 10'000) : count));
  for (const char* id : {"A1", "B2", "C2", "M1", "S2", "T7"})
    print(plumb::agree_on_boxes(plumb::family_kind(id), count / 3));
  print(plumb::agree_on_rotations(count / 3));
  print(plumb::agree_on_fresnel(count));
  fmt::print("| all | {} | {} | |\n", all_cases, all_disagreements);
  return all_disagreements == 0 ? 0 : 1;
}
