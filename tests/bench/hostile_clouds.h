/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Clouds that are hard on a spatial index. */
#ifndef JALON_BENCH_HOSTILE_CLOUDS_H
#define JALON_BENCH_HOSTILE_CLOUDS_H

#define JALON_TEST_PLAIN_PROGRAM
#include "../capi/support.h"

#include <math.h>

/* Three numbers in [0, 1) of point i. */
static inline void draw(uint64_t i, double p[3]) {
  for (uint64_t axis = 0; axis < 3; ++axis) p[axis] = uniform(12, 3 * i + axis);
}

static inline void random_point(uint64_t i, uint64_t n, double p[3]) {
  (void)n;
  draw(i, p);
}

/* The spacing falls by half from point to point: nearly all of them lie in one cell of the finest grid. */
static inline void halving_point(uint64_t i, uint64_t n, double p[3]) {
  (void)n;
  draw(i, p);
  p[0] = ldexp(1, -(int)(i % 900));
  p[1] = ldexp(1, -(int)(i % 600));
  p[2] = ldexp(p[2], -(int)(i % 300));
}

/* A line on which each step is a fixed part of the way left, down to the smallest number. */
static inline void line_point(uint64_t i, uint64_t n, double p[3]) {
  p[0] = exp(-700.0 * (double)i / (double)n);
  p[1] = p[2] = 0;
}

static inline void one_far_point(uint64_t i, uint64_t n, double p[3]) {
  (void)n;
  p[0] = p[1] = p[2] = i == 17 ? 1e9 : 0.3;
}

static inline void equal_point(uint64_t i, uint64_t n, double p[3]) {
  (void)i, (void)n;
  p[0] = p[1] = p[2] = 0.3;
}

static inline void far_outlier_point(uint64_t i, uint64_t n, double p[3]) {
  (void)n;
  draw(i, p);
  if (i == 17) p[0] = p[1] = -1e6, p[2] = 1e6;
}

/* Runs of 500 equal points. */
static inline void runs_point(uint64_t i, uint64_t n, double p[3]) {
  (void)n;
  draw(i / 500, p);
}

static inline void straight_point(uint64_t i, uint64_t n, double p[3]) {
  p[0] = (double)i / (double)n;
  p[1] = p[2] = 0;
}

/* Fifty turns, one beside the other. */
static inline void spiral_point(uint64_t i, uint64_t n, double p[3]) {
  const double t = sqrt((double)i / (double)n);
  p[0] = t * cos(314 * t);
  p[1] = t * sin(314 * t);
  p[2] = 0;
}

/* A logarithmic spiral of some fifty turns into its centre. */
static inline void shrinking_point(uint64_t i, uint64_t n, double p[3]) {
  const double t = (double)i / (double)n, radius = exp(-30 * t);
  p[0] = radius * cos(300 * t);
  p[1] = radius * sin(300 * t);
  p[2] = 0;
}

static inline void lattice_point(uint64_t i, uint64_t n, double p[3]) {
  const uint64_t side = (uint64_t)ceil(cbrt((double)n));
  p[0] = (double)(i % side) / (double)side;
  p[1] = (double)(i / side % side) / (double)side;
  p[2] = (double)(i / side / side) / (double)side;
}

/* A cloud as they are, and one point at the origin of its national grid. */
static inline void grid_origin_point(uint64_t i, uint64_t n, double p[3]) {
  (void)n;
  draw(i, p);
  if (i == 17) p[0] = p[1] = p[2] = 0;
  else p[0] += 652000, p[1] += 6861000;
}

static inline void two_clusters_point(uint64_t i, uint64_t n, double p[3]) {
  (void)n;
  draw(i, p);
  if (i % 2 == 1) p[0] += 1e12;
}

/* The middle third left out forty times, on all three axes. */
static inline void cantor_point(uint64_t i, uint64_t n, double p[3]) {
  (void)n;
  for (int axis = 0; axis < 3; ++axis) {
    uint64_t bits = (uint64_t)(uniform(13 + (uint64_t)axis, i) * 0x1p40);
    p[axis] = 0;
    for (double third = 2.0 / 3; bits != 0; bits >>= 1, third /= 3) p[axis] += bits & 1 ? third : 0;
  }
}

static inline void pile_point(uint64_t i, uint64_t n, double p[3]) {
  (void)n;
  draw(i, p);
  if (i % 2 == 1) p[0] = p[1] = p[2] = 0.25;
}

/* Every point twice, half of the cloud apart. */
static inline void doubled_point(uint64_t i, uint64_t n, double p[3]) { draw(i % (n / 2 + 1), p); }

/* Balls of some micrometres about a hundred places of a national grid. */
static inline void micrometre_point(uint64_t i, uint64_t n, double p[3]) {
  double place[3];
  (void)n;
  draw(i, p);
  draw(1000000007 + i % 100, place);
  p[0] = 652000 + 1000 * place[0] + 1e-5 * p[0];
  p[1] = 6861000 + 1000 * place[1] + 1e-5 * p[1];
  p[2] = 100 * place[2] + 1e-5 * p[2];
}

static const struct {
  const char* name;
  void (*point)(uint64_t i, uint64_t n, double p[3]);
} kHostile[] = {
    {"random", random_point},
    {"halving", halving_point},
    {"line", line_point},
    {"one far", one_far_point},
    {"far outlier", far_outlier_point},
    {"equal", equal_point},
    {"runs", runs_point},
    {"straight", straight_point},
    {"spiral", spiral_point},
    {"shrinking spiral", shrinking_point},
    {"lattice", lattice_point},
    {"grid origin", grid_origin_point},
    {"two clusters", two_clusters_point},
    {"cantor", cantor_point},
    {"pile", pile_point},
    {"doubled", doubled_point},
    {"micrometres", micrometre_point},
};
enum { kHostileCount = sizeof kHostile / sizeof *kHostile };

static inline jalon_cloud* hostile_cloud(int which, uint64_t n) {
  double* xyz = malloc((size_t)n * 24 + 24);
  if (xyz == NULL) fail_msg("no memory for %llu points", (unsigned long long)n);
  for (uint64_t i = 0; i < n; ++i) kHostile[which].point(i, n, xyz + 3 * i);
  jalon_cloud* cloud = cloud_of(xyz, n);
  free(xyz);
  return cloud;
}

#endif
