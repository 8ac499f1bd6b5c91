/* SPDX-License-Identifier: Apache-2.0 */
#ifndef PLUMB_CORPUS_H
#define PLUMB_CORPUS_H

/* A certified corpus: rays, surfaces, and the exact answers (docs/corpus-format.md). One header, then `count` records
 * of `record_size` bytes each. Little endian; no padding; every double is exactly the number that is meant. */

#include <stdint.h>

#define PLUMB_CORPUS_MAGIC "PLUMBCRP"
#define PLUMB_CORPUS_VERSION 1u

typedef struct plumb_corpus_header {
  char magic[8];
  uint32_t version;
  uint32_t record_size; /* sizeof(plumb_corpus_record) */
  uint64_t count;
  uint64_t seed;
  char family[8];     /* "T2", padded with zeros */
  uint32_t precision; /* 1: all inputs are floats, 2: doubles */
  uint32_t reserved;
} plumb_corpus_header;

enum plumb_corpus_shape {
  PLUMB_CORPUS_TRIANGLE = 0, /* numbers: a, b, c */
  PLUMB_CORPUS_SPHERE = 1,   /* centre, radius */
  PLUMB_CORPUS_BOX = 2,      /* smallest corner, largest corner */
  PLUMB_CORPUS_CYLINDER = 3, /* centre, radius, height; the axis along z */
  PLUMB_CORPUS_CONE = 4      /* centre, z of the tip, radius at the centre, height */
};

enum plumb_corpus_class {
  PLUMB_CORPUS_MISS = 0,
  PLUMB_CORPUS_HIT = 1,
  PLUMB_CORPUS_BOUNDARY = 2, /* the first crossing is on an edge, a vertex or a rim */
  PLUMB_CORPUS_TANGENT = 3   /* the first crossing is a double root */
};

enum plumb_corpus_crossing_flags {
  PLUMB_CORPUS_FREE = 1, /* may be reported or not */
  PLUMB_CORPUS_AT_MIN = 2,
  PLUMB_CORPUS_AT_MAX = 4
};

typedef struct plumb_corpus_crossing {
  double t_below, t_above; /* equal where t is a double, else neighbouring doubles around it */
  double u, v;             /* triangles: weights of the second and third vertex, rounded to nearest */
  uint32_t flags;
  uint32_t part;
} plumb_corpus_crossing;

typedef struct plumb_corpus_record {
  uint32_t shape;
  uint32_t hit_class;
  double numbers[9];
  double world_from_object[12];                 /* upper three rows, row by row */
  double origin[3], direction[3], t_min, t_max; /* world space; closed range */
  uint32_t crossing_count;                      /* in the range, by rising t; at most 4 */
  uint32_t inside;                              /* 1: the origin lies strictly inside of the solid */
  plumb_corpus_crossing crossings[4];
  double condition; /* errors of t are to be divided by it */
  double margin; /* triangles: how far from the nearest edge the ray passes, in unit roundoffs of `precision`; else 0 */
} plumb_corpus_record;

#endif
