// Adds to one variable from two threads of the renderer's own pool, without a lock: the tsan preset must report it.

#include <cstdio>

#include "renderer/film/tiles.h"

int main() {
  long sum = 0;
  plumb::for_each_item(2, 10000, [&](int, int item) { sum += item; });
  std::printf("%ld\n", sum);
  return 0;
}
