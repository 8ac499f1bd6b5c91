// contact_sheet OUT.png COLUMNS PICTURE...: the pictures (8-bit PNG) side by side in the order given, each in the
// middle of a cell as large as the largest, on white.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "renderer/image/image.h"
#include "renderer/image/read_picture.h"
#include "renderer/image/write_image.h"

namespace {

constexpr int kGap = 4;  // pixels of white between the cells

struct Sheet {
  int width, height;
  std::vector<std::uint8_t> levels =
      std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);

  void put(const plumb::Picture& picture, int left, int top) {
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        const auto pixel =
            static_cast<std::size_t>(top + y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(left + x);
        for (std::size_t channel = 0; channel < 3; ++channel)
          levels[3 * pixel + channel] = static_cast<std::uint8_t>(picture.pixel(x, y)[channel]);
      }
  }
};

Sheet sheet_of(const std::vector<plumb::Picture>& pictures, int columns) {
  int cell_width = 0, cell_height = 0;
  for (const plumb::Picture& picture : pictures) {
    cell_width = std::max(cell_width, picture.width);
    cell_height = std::max(cell_height, picture.height);
  }
  const int count = static_cast<int>(pictures.size()), rows = (count + columns - 1) / columns;
  Sheet sheet{columns * (cell_width + kGap) - kGap, rows * (cell_height + kGap) - kGap};
  for (int i = 0; i < count; ++i) {
    const plumb::Picture& picture = pictures[static_cast<std::size_t>(i)];
    sheet.put(picture, i % columns * (cell_width + kGap) + (cell_width - picture.width) / 2,
              i / columns * (cell_height + kGap) + (cell_height - picture.height) / 2);
  }
  return sheet;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int columns = argc < 4 ? 0 : std::stoi(argv[2]);
    if (columns < 1) {
      std::cerr << "usage: contact_sheet OUT.png COLUMNS PICTURE...\n";
      return 2;
    }
    std::vector<plumb::Picture> pictures;
    for (int i = 3; i < argc; ++i) pictures.push_back(plumb::read_picture(argv[i]));
    const Sheet sheet = sheet_of(pictures, columns);
    plumb::write_png(sheet.levels, sheet.width, sheet.height, argv[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}
