// A hierarchy after a search for duplicates that compares each primitive with all before it, WRONG ON PURPOSE.
#pragma once

#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "hierarchy.h"

struct Search : Hierarchy {
  static constexpr int kThreads = 1;
  void build(std::vector<Primitive> list) {
    std::vector<Primitive> different;
    std::vector<std::uint64_t> keys;
    for (const Primitive& p : list) {
      const std::uint64_t key = key_of(p);
      bool known = false;
      for (std::uint64_t other : keys)
        if (other == key) known = true;
      if (known) continue;
      keys.push_back(key);
      different.push_back(p);
    }
    Hierarchy::build(std::move(different), median_split);
  }

 private:
  // Made from all bits of its numbers (64-bit FNV-1a by words).
  static std::uint64_t key_of(const Primitive& p) {
    const double numbers[] = {p.a.x,     p.a.y,     p.a.z,     p.edge1.x, p.edge1.y,
                              p.edge1.z, p.edge2.x, p.edge2.y, p.edge2.z, p.radius};
    std::uint64_t key = 14695981039346656037u;
    for (double number : numbers) {
      std::uint64_t bits;
      std::memcpy(&bits, &number, sizeof bits);
      key = (key ^ bits ^ bits >> 32) * 1099511628211u;
    }
    return key;
  }
};
