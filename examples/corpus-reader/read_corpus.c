/* SPDX-License-Identifier: Apache-2.0
 * Checks a kernel against an exported corpus. Needs plumb_corpus.h alone: cc -O2 -ffp-contract=off -I conformance/kernel read_corpus.c */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plumb_corpus.h"

/* The kernel under test: Moller and Trumbore's, in float. Put your own here. */
static int hit_triangle(const plumb_corpus_record* r, float* t) {
  const double* n = r->numbers;
  const float d[3] = {(float)r->direction[0], (float)r->direction[1], (float)r->direction[2]};
  float e1[3], e2[3], s[3];
  for (int i = 0; i < 3; ++i) {
    e1[i] = (float)n[3 + i] - (float)n[i];
    e2[i] = (float)n[6 + i] - (float)n[i];
    s[i] = (float)r->origin[i] - (float)n[i];
  }
  const float p[3] = {d[1] * e2[2] - d[2] * e2[1], d[2] * e2[0] - d[0] * e2[2], d[0] * e2[1] - d[1] * e2[0]};
  const float det = e1[0] * p[0] + e1[1] * p[1] + e1[2] * p[2];
  if (det == 0) return 0;
  const float inv = 1 / det;
  const float u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) * inv;
  if (!(u >= 0 && u <= 1)) return 0;
  const float q[3] = {s[1] * e1[2] - s[2] * e1[1], s[2] * e1[0] - s[0] * e1[2], s[0] * e1[1] - s[1] * e1[0]};
  const float v = (d[0] * q[0] + d[1] * q[1] + d[2] * q[2]) * inv;
  if (!(v >= 0 && u + v <= 1)) return 0;
  *t = (e2[0] * q[0] + e2[1] * q[1] + e2[2] * q[2]) * inv;
  return *t >= (float)r->t_min && *t <= (float)r->t_max;
}

int main(int argc, char** argv) {
  FILE* file = argc == 2 ? fopen(argv[1], "rb") : NULL;
  plumb_corpus_header header;
  plumb_corpus_record r;
  if (!file || fread(&header, sizeof header, 1, file) != 1 || memcmp(header.magic, PLUMB_CORPUS_MAGIC, 8) != 0 ||
      header.version != PLUMB_CORPUS_VERSION || header.record_size != sizeof r) {
    fprintf(stderr, "usage: read_corpus CORPUS, written by plumb corpus export (version 1)\n");
    return 2;
  }
  unsigned long long rays = 0, free_rays = 0, false_misses = 0, false_hits = 0;
  for (; rays < header.count && fread(&r, sizeof r, 1, file) == 1; ++rays) {
    if (r.shape != PLUMB_CORPUS_TRIANGLE) return fprintf(stderr, "this kernel knows triangles only\n"), 2;
    float t = 0;
    const int hit = hit_triangle(&r, &t);
    const int is_free = r.crossing_count > 0 && (r.crossings[0].flags & PLUMB_CORPUS_FREE);
    free_rays += is_free;
    false_misses += r.crossing_count > 0 && !is_free && !hit;
    false_hits += r.crossing_count == 0 && hit;
  }
  printf("%s: %llu rays, %llu free, %llu false misses, %llu false hits\n", header.family, rays, free_rays, false_misses, false_hits);
  return rays == header.count ? 0 : 2;
}
