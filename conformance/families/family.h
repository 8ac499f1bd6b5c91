#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "conformance/kernel/plumb_kernel.h"
#include "conformance/subject/subject.h"

namespace plumb {

/// One question: rays at one surface.
struct FamilyCase {
  SubjectSurface surface;
  std::vector<Ray> rays;
  /// By how much the case is ill-conditioned: errors of t are divided by it (1 where it is well-conditioned).
  double condition = 1;
};

/// A deterministic source of hard cases. All numbers of a case are representable in `precision`. The same seed gives
/// the same cases on every machine: own integer random numbers, + - * / and sqrt alone.
class Family {
 public:
  virtual ~Family() = default;
  /// The next case. Never ends; the n-th case depends on the seed and n alone.
  virtual FamilyCase next() = 0;
};

/// A row of the catalogue (`../shared` names: T1 .. T12, B1 .. B3, S1 .. S5, C1, C2, M1 .. M4, A1), and the controls
/// (T0, S0, B0, C0): random rays at ordinary shapes.
struct FamilyKind {
  std::string_view id;       ///< `T1`
  std::string_view name;     ///< `edge`
  std::string_view recipe;   ///< how a case is made, one sentence
  std::string_view mistake;  ///< what naive code gets wrong
  std::unique_ptr<Family> (*make)(std::uint64_t seed, plumb_precision precision);
};

/// All, in the catalogue's order.
std::span<const FamilyKind* const> family_kinds();
/// Throws InputError naming the nearest known id.
const FamilyKind& family_kind(std::string_view id);

}  // namespace plumb
