#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "meshes/generators/random_bits.h"

namespace plumb::bench {

/// In which order `count` contestants have their turns in a round: each number below `count` once, shuffled by the
/// number of the round. In a fixed or turning order each would always inherit the caches, the free memory and the
/// clock of the same other one.
inline std::vector<std::size_t> turns(std::size_t round, std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  RandomBits random(1, round);
  for (std::size_t left = count; left > 1; --left) std::swap(order[left - 1], order[random.bits() % left]);
  return order;
}

}  // namespace plumb::bench
