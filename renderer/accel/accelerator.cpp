#include "renderer/accel/accelerator.h"

#include <array>

namespace plumb {

std::span<const std::string_view> accel_names() {
  static constexpr std::array<std::string_view, 3> kNames{"linear", "bvh2", "bvh8"};
  return kNames;
}

Accelerator::Accelerator(Accel accel, std::span<const Bounds3> bounds, double origin_margin)
    : accel_(accel),
      count_(static_cast<std::uint32_t>(bounds.size())),
      hierarchy_(accel != Accel::linear ? bounds : std::span<const Bounds3>{}, origin_margin) {}

}  // namespace plumb
