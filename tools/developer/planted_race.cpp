// Adds to one variable from two threads of the renderer's own pool, without a lock: the tsan preset must report it. For
// long enough that the second thread comes to it on a busy machine, too.

#include <cstdio>

#include "renderer/film/tiles.h"

int main() {
  long sum = 0;
  plumb::for_each_item(2, 3000000, [&](int, int item) { sum += item; });
  std::printf("%ld\n", sum);
  return 0;
}
