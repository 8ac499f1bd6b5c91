#include "meshes/formats/point_joiner.h"

#include <bit>
#include <utility>

namespace plumb {
namespace {

/// Spreads every bit over all [Steele 2014, the finaliser of SplitMix64].
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

std::uint64_t hash_of(const Point3& p) {
  // Adding 0 makes 0 of -0, which are equal and so must meet.
  const auto x = std::bit_cast<std::uint64_t>(p.x + 0.0), y = std::bit_cast<std::uint64_t>(p.y + 0.0),
             z = std::bit_cast<std::uint64_t>(p.z + 0.0);
  return mixed(mixed(mixed(x) + y) + z);
}

}  // namespace

std::uint32_t PointJoiner::vertex_at(std::array<float, 3> point) {
  const Point3 p{double{point[0]}, double{point[1]}, double{point[2]}};
  std::uint32_t& entry = table_[place_of(p)];
  if (entry != kNone) return entry;
  const auto vertex = static_cast<std::uint32_t>(positions_.size());
  entry = vertex;
  positions_.push_back(p);
  if (positions_.size() * 2 > table_.size()) grow();
  return vertex;
}

std::size_t PointJoiner::place_of(const Point3& point) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t place = hash_of(point) & mask;
  while (table_[place] != kNone && positions_[table_[place]] != point) place = (place + 1) & mask;
  return place;
}

void PointJoiner::grow() {
  const std::size_t size = 2 * table_.size();
  table_.clear();
  table_.shrink_to_fit();
  table_.assign(size, kNone);
  for (std::size_t v = 0; v < positions_.size(); ++v) table_[place_of(positions_[v])] = static_cast<std::uint32_t>(v);
}

}  // namespace plumb
