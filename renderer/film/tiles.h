#pragma once

#include <functional>
#include <vector>

namespace plumb {

/// A rectangle of pixels, rows counted from the top.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Cuts a rectangle into squares of 32 pixels (narrower at its right and bottom), row by row.
std::vector<PixelRect> tiles_of(const PixelRect& rect);

/// As many threads as wanted; for 0 as many as there are processors.
int thread_count(int wanted);

/// Calls work(worker, item) once for each item in [0, count), from `threads` threads (at least 1) at a time, each
/// worker on one thread. Items are taken in order, by whoever is free. The first exception stops the others after their
/// item and is thrown on.
void for_each_item(int threads, int count, const std::function<void(int worker, int item)>& work);

}  // namespace plumb
