/* SPDX-License-Identifier: Apache-2.0
 * A kernel for plumb in plain C: every triangle for every ray, by Moller and Trumbore, in doubles. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "plumb_kernel.h"

struct plumb_scene {
  size_t count;
  struct triangle { uint32_t surface, primitive; double a[3], e1[3], e2[3]; } triangles[];
};

static plumb_scene* build(const plumb_surface* surfaces, size_t count, char* error, size_t error_size) {
  size_t total = 0;
  for (size_t s = 0; s < count; ++s) total += surfaces[s].mesh.triangle_count;
  plumb_scene* scene = malloc(sizeof *scene + total * sizeof(struct triangle));
  if (!scene) { snprintf(error, error_size, "no memory for %zu triangles", total); return NULL; }
  scene->count = 0;
  for (size_t s = 0; s < count; ++s)
    for (size_t i = 0; i < surfaces[s].mesh.triangle_count; ++i) {
      struct triangle* to = &scene->triangles[scene->count++];
      const uint32_t* v = surfaces[s].mesh.triangles + 3 * i;
      *to = (struct triangle){.surface = (uint32_t)s, .primitive = (uint32_t)i};
      for (int k = 0; k < 3; ++k) {
        to->a[k] = surfaces[s].mesh.positions[3 * v[0] + k];
        to->e1[k] = surfaces[s].mesh.positions[3 * v[1] + k] - to->a[k];
        to->e2[k] = surfaces[s].mesh.positions[3 * v[2] + k] - to->a[k];
      }
    }
  return scene;
}
static void destroy(plumb_scene* scene) { free(scene); }

static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static void cross(const double* a, const double* b, double* c) {
  for (int k = 0; k < 3; ++k) c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static void closest_hit(const plumb_scene* scene, const plumb_rays* rays, plumb_hits* hits) {
  for (size_t r = 0; r < rays->count; ++r) {
    const double o[3] = {rays->ox[r], rays->oy[r], rays->oz[r]}, d[3] = {rays->dx[r], rays->dy[r], rays->dz[r]};
    hits->surface[r] = PLUMB_MISS;
    for (const struct triangle* tri = scene->triangles; tri < scene->triangles + scene->count; ++tri) {
      double s[3], p[3], q[3];
      for (int k = 0; k < 3; ++k) s[k] = o[k] - tri->a[k];
      cross(d, tri->e2, p);
      cross(s, tri->e1, q);
      const double det = dot(tri->e1, p), u = dot(s, p) / det, v = dot(d, q) / det, t = dot(tri->e2, q) / det;
      if (!(u >= 0 && v >= 0 && u + v <= 1 && t >= rays->t_min[r] && t <= rays->t_max[r] && isfinite(t))) continue;
      if (hits->surface[r] != PLUMB_MISS && hits->t[r] <= t) continue;
      hits->surface[r] = tri->surface, hits->primitive[r] = tri->primitive;
      hits->t[r] = t, hits->u[r] = u, hits->v[r] = v;
    }
  }
}

const plumb_kernel* plumb_kernel_v1(void) {
  static const plumb_kernel table = {
      PLUMB_KERNEL_VERSION, sizeof(plumb_kernel), "kernel-c", "Moller-Trumbore in C, every triangle for every ray",
      {PLUMB_DOUBLE, PLUMB_DOUBLE, PLUMB_CULL_NONE, PLUMB_EDGE_NONE, PLUMB_RANGE_CLOSED, PLUMB_INSIDE_HITS_EXIT,
       PLUMB_MESHES, PLUMB_THREAD_SAFE, 0},
      build, destroy, closest_hit, NULL, NULL, NULL};
  return &table;
}
