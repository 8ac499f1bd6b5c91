#pragma once

#include <cstdint>
#include <vector>

#include "renderer/image/image.h"
#include "renderer/math/vec3.h"
#include "scenes/load_meshes.h"
#include "scenes/scene_description.h"

namespace plumb {

/// How one correct program differs from another. The textbook tracer is a second tracer, written as textbooks and
/// students write it: surfaces, shading and hierarchy share no code with the renderer, whose pictures it is there to
/// question. Each option by itself is a program that a careful student may hand in; together they need not be
/// (`other_formulas` in single precision makes acne).
struct TextbookOptions {
  /// float in place of double in everything after the reading of the file: transforms, vertices, rays, shading.
  bool single = false;
  /// Where secondary and shadow rays begin to count, in units of their t. In single precision less than 1e-5 makes
  /// acne.
  double t_min = 1e-6;
  /// The terms of dot products, matrix products, lights and samples are added from the last to the first.
  bool reverse_sums = false;
  /// The other formula wherever textbooks have two: see formulas.h.
  bool other_formulas = false;
  /// Moves every camera ray, in pixels, to the right and up.
  double shift_x = 0, shift_y = 0;
  /// Each coordinate of vertices, centres and corners, and each radius, is multiplied by 1 + vertex_noise r, where r
  /// in [-1, 1] depends on the surface, the vertex and the axis alone. Equal coordinates of one box stay equal.
  double vertex_noise = 0;

  /// What the accepted variant says: N x N samples a pixel, deepest ray, cutoff, and Schlick's approximation in place
  /// of Fresnel's equations.
  int grid = 1;
  int max_depth = 12;
  double min_contribution = 0.01;
  bool schlick = false;
  /// Of the picture, in pixels.
  int width = 0, height = 0;
};

/// No perturbation, and what the scene says of its size, samples (rounded to the nearest square), depth and cutoff.
TextbookOptions textbook_options(const SceneDescription& description);

/// What one sample of a picture saw. Where two programs agree in primary, face, shadows and path, their colours differ
/// by rounding alone.
struct TextbookSample {
  /// Linear, not clamped.
  Color color;
  /// Number of the placed surface, from 1 in the order of the file; 0 where the ray met nothing.
  std::uint32_t primary = 0;
  /// Which smooth piece of it: of a box its face, of a cylinder or cone the side or a cap, of a mesh without normals
  /// the triangle. Of a mesh with normals always 0.
  std::uint32_t face = 0;
  /// Hash of the lights that lit the first hit.
  std::uint32_t shadows = 0;
  /// Hash of all that lies deeper: surfaces, faces, their lights, and which rays were reflected, refracted or dropped.
  std::uint32_t path = 0;
  /// The smallest |cos| between a ray and the normal where it hit, over the whole path; 1 if nothing was hit.
  float grazing = 1;
  friend bool operator==(const TextbookSample&, const TextbookSample&) = default;
};

/// All samples: rows of pixels from the top, grid x grid a pixel, in each from the bottom row (j) and the left (i): the
/// sample of pixel (x, y), y from the top, is number ((y width + x) grid + j) grid + i. By the rules of the dialect
/// pa3-2011. `threads` as in thread_count; the samples do not depend on it, nor on the machine but for the last bit of
/// pow. Throws InputError, at its element, for a transform that has no inverse in the options' arithmetic, and
/// std::invalid_argument for a width, height or grid that is not positive.
std::vector<TextbookSample> textbook_samples(const SceneDescription& description, const MeshTable& meshes,
                                             const TextbookOptions& options, int threads);

/// The mean of each pixel's samples. The samples must be those of the options.
Image textbook_picture(const std::vector<TextbookSample>& samples, const TextbookOptions& options);

}  // namespace plumb
