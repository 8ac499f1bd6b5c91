/* SPDX-License-Identifier: Apache-2.0 */
#ifndef PLUMB_KERNEL_H
#define PLUMB_KERNEL_H

/* The door for an intersection kernel: a shared library in any language that can export one C function,
 *
 *     const plumb_kernel* plumb_kernel_v1(void);
 *
 * which returns a table that lives as long as the library. `plumb check ./kernel.so` loads it in a process of its own
 * and judges its answers against exact arithmetic, by the contract that it declares.
 *
 * Numbers are doubles everywhere, so that there is one form of each array. A kernel that computes in float says so
 * (`precision`); it is then given only numbers that are floats, and may convert them without a loss. Angles do not
 * occur; lengths are in scene units. Matrices are the upper three rows of world_from_object, row by row. All arrays are
 * the caller's. */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define PLUMB_KERNEL_VERSION 1u

enum plumb_precision { PLUMB_FLOAT = 1, PLUMB_DOUBLE = 2 };

/* Which sides of a triangle are hit, by its winding: a, b, c run counter-clockwise seen from the front. */
enum plumb_culling { PLUMB_CULL_NONE = 0, PLUMB_CULL_BACK = 1 };

/* What is promised of a ray through an edge or a vertex. */
enum plumb_edge_rule {
  PLUMB_EDGE_CLOSED = 1,   /* each triangle by itself includes its edges */
  PLUMB_EDGE_TOP_LEFT = 2, /* exactly one of the triangles around an edge point is hit */
  PLUMB_EDGE_WATERTIGHT =
      3,              /* at least one of them is hit; single triangles may differ from the exact class by a rounding */
  PLUMB_EDGE_NONE = 4 /* nothing: rays may slip through */
};

/* Whether t_min and t_max themselves belong to the range. */
enum plumb_range { PLUMB_RANGE_CLOSED = 1, PLUMB_RANGE_OPEN = 2 };

/* A ray that begins inside of a solid. */
enum plumb_inside { PLUMB_INSIDE_HITS_EXIT = 1, PLUMB_INSIDE_MISSES = 2 };

/* Bits of `shapes`: what can be built. */
enum plumb_shapes { PLUMB_MESHES = 1, PLUMB_SPHERES = 2, PLUMB_BOXES = 4, PLUMB_CYLINDERS = 8, PLUMB_CONES = 16 };

/* Bits of `capabilities`. A function whose bit is missing may be null. */
enum plumb_capabilities {
  PLUMB_TRANSFORMS = 1, /* primitives under a matrix other than the identity */
  PLUMB_ANY_HIT = 2,
  PLUMB_ALL_HITS = 4,
  PLUMB_BOUNDS = 8,
  PLUMB_THREAD_SAFE = 16 /* a built scene may be asked from several threads at once */
};

typedef struct plumb_contract {
  uint32_t precision;   /* plumb_precision: of coordinates, rays and range */
  uint32_t t_precision; /* plumb_precision: of t, u and v */
  uint32_t culling;
  uint32_t edge_rule;
  uint32_t range;
  uint32_t inside;
  uint32_t shapes;
  uint32_t capabilities;
  double largest; /* of |coordinate| that may be given; 0 for no limit beyond the precision's own */
} plumb_contract;

typedef struct plumb_mesh {
  const double* positions; /* 3 a vertex */
  size_t vertex_count;
  const uint32_t* triangles; /* 3 indices a triangle, each < vertex_count */
  size_t triangle_count;
} plumb_mesh;

enum plumb_kind { PLUMB_MESH = 0, PLUMB_SPHERE = 1, PLUMB_BOX = 2, PLUMB_CYLINDER = 3, PLUMB_CONE = 4 };

/* One surface, in its own frame. Spheres, cylinders and cones: center, radius; the latter two have their axis along z
 * through the centre, which lies at half of the height; a cone's radius is that at the centre's z, and `tip_z` the z of
 * its tip. Solids are capped. */
typedef struct plumb_surface {
  uint32_t kind; /* plumb_kind */
  plumb_mesh mesh;
  double center[3], radius, height, tip_z;
  double box_min[3], box_max[3];
  double world_from_object[12];
} plumb_surface;

/* Rays, each number in an array of its own. The direction has any length but zero; t counts in its lengths. */
typedef struct plumb_rays {
  size_t count;
  const double *ox, *oy, *oz, *dx, *dy, *dz, *t_min, *t_max;
} plumb_rays;

#define PLUMB_MISS 0xffffffffu

/* Where the answers go. surface[i] is the index of the surface, or PLUMB_MISS, which leaves the rest of i unread;
 * primitive[i] the triangle of a mesh, 0 for others; u and v the weights of the triangle's second and third vertex. */
typedef struct plumb_hits {
  uint32_t* surface;
  uint32_t* primitive;
  double *t, *u, *v;
} plumb_hits;

typedef struct plumb_scene plumb_scene; /* the kernel's own */

typedef struct plumb_kernel {
  uint32_t version;        /* PLUMB_KERNEL_VERSION */
  uint32_t size;           /* sizeof(plumb_kernel) */
  const char* name;        /* letters, digits, '-', '_' and '.' */
  const char* description; /* one line: versions, instruction set, flags */
  plumb_contract contract;

  /* Null if it cannot; then a sentence may be put in `error` (error_size bytes, ending in 0). What is passed need not
   * be kept alive by the caller after the call. */
  plumb_scene* (*build)(const plumb_surface* surfaces, size_t count, char* error, size_t error_size);
  void (*destroy)(plumb_scene*);
  /* The hit with the smallest t in each ray's range. */
  void (*closest_hit)(const plumb_scene*, const plumb_rays*, plumb_hits*);
  /* hit[i] = 1 if anything lies in the ray's range, else 0. PLUMB_ANY_HIT. */
  void (*any_hit)(const plumb_scene*, const plumb_rays*, uint8_t* hit);
  /* All hits of ray i in any order, at most `capacity` of each (the array of ray i begins at i * capacity); count[i] is
   * how many there are, even if more than that. PLUMB_ALL_HITS. */
  void (*all_hits)(const plumb_scene*, const plumb_rays*, size_t capacity, plumb_hits*, uint32_t* count);
  /* The world box of each surface: min x, y, z, max x, y, z. PLUMB_BOUNDS. */
  void (*bounds)(const plumb_scene*, double* six_a_surface);
} plumb_kernel;

/* What the library exports. */
typedef const plumb_kernel* (*plumb_kernel_entry)(void);
#define PLUMB_KERNEL_ENTRY "plumb_kernel_v1"

#ifdef __cplusplus
}
#endif
#endif
