#pragma once

#include <bit>
#include <cstdint>

#include "renderer/math/ray.h"
#include "renderer/math/transform.h"

namespace plumb {

/// A world-space ray in the frame of a surface that a transform has placed. Taken there, its origin and direction are
/// rounded; a surface that decides exactly takes the errors into account, and goes back to the world's ray, with the
/// matrix as it stands, where they leave a decision open. Refers to the ray and the transform.
struct PlacedRay {
  /// For a surface without a transform: nothing is rounded.
  explicit PlacedRay(const Ray& ray) : world(&ray) {}
  /// In a frame of its own. An identity changes nothing. The transform has been made of its matrix, so that its inverse
  /// is near the exact one: not by inverse().
  PlacedRay(const Ray& world_ray, const Transform& transform);

  /// How far the rounded ray may pass, on any axis, from where the exact one is, at any t where that has no coordinate
  /// above `reach`. Infinity where the direction has no digits.
  double drift(double reach) const;

  /// In object space, with the world's range: t means the same.
  const Ray& object() const { return world_from_object ? object_ : *world; }

  /// Whether no coordinate is off.
  bool is_exact() const {
    // As whole numbers, of which none is read together with another: both may have been written just before.
    return (std::bit_cast<std::uint64_t>(origin_error) | std::bit_cast<std::uint64_t>(direction_error)) == 0;
  }

  /// Hits strictly beyond need not be found. Never decides what lies in the range.
  double nearest = std::numeric_limits<double>::infinity();
  /// How far any coordinate of the origin and of the direction may be off.
  double origin_error = 0;
  double direction_error = 0;
  const Ray* world;
  /// Null where it is the identity.
  const Transform* world_from_object = nullptr;

 private:
  /// Where it is not the world's own; else nothing is written here, as every ray is placed.
  union {
    Ray object_;
  };
};

}  // namespace plumb
