#pragma once

#include <array>
#include <cstdint>

namespace plumb {

enum class RayKind { primary, reflection, refraction, shadow };
constexpr std::size_t kRayKinds = 4;

/// What tracing cost, counted by each thread for itself and added up at the end.
struct TraceCounters {
  std::array<std::uint64_t, kRayKinds> rays{};
  std::uint64_t node_visits = 0;
  std::uint64_t primitive_tests = 0;

  void add(const TraceCounters& other) {
    for (std::size_t i = 0; i < kRayKinds; ++i) rays[i] += other.rays[i];
    node_visits += other.node_visits;
    primitive_tests += other.primitive_tests;
  }
  friend bool operator==(const TraceCounters&, const TraceCounters&) = default;
};

}  // namespace plumb
