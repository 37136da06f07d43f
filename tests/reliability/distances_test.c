/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */

/* Distances between clouds and from models against all pairs, in extended precision: drawn configurations and
 * degenerate ones, near the origin and on a national grid. */
#include <math.h>

#include "support.h"

enum { kPoints = 60, kReferences = 80, kRandom = 500, kDegenerate = 100 };

/* What the configurations' points are: those from kLine on are the degenerate ones. */
enum { kBall, kSheet, kLumps, kFarAndNear, kLine, kOnePlace, kLattice, kTwoPlaces, kLayouts };
static const char* const layout_names[] = {"ball", "sheet",     "lumps",   "far and near",
                                           "line", "one place", "lattice", "two places"};

typedef struct {
  uint64_t seed, next;
} draw;
static double drawn(draw* d) { return uniform(d->seed, d->next++); }

/* Eastings and northings of seven digits before the point, as national grids have. */
static const double grids_m[3][3] = {
    {0, 0, 0}, {1652381.25, 6862047.5, 35}, {-3.125, 4.5, 1250.75}};

static void place(draw* d, int layout, uint64_t i, const double* shift, double* p) {
  const double a = drawn(d), b = drawn(d), c = drawn(d);
  double q[3] = {10 * a, 10 * b, 10 * c};
  const double far = layout == kFarAndNear ? pow(10, 6 * drawn(d) - 3) : 1;
  switch (layout) {
    case kSheet:
      q[2] = 0.01 * c;
      break;
    case kLumps:
      q[0] = floor(3 * a) + 0.01 * b, q[1] = 0.01 * c, q[2] = 0.01 * drawn(d);
      break;
    case kFarAndNear:
      q[0] *= far, q[1] *= far, q[2] *= far;
      break;
    case kLine:
      q[1] = 2 * q[0], q[2] = -q[0];
      break;
    case kOnePlace:
      q[0] = q[1] = q[2] = 0.5;
      break;
    case kLattice:
      q[0] = floor(q[0] / 3), q[1] = floor(q[1] / 3), q[2] = floor(q[2] / 3);
      break;
    case kTwoPlaces:
      q[0] = q[1] = 0, q[2] = i % 2 == 0 ? 0 : 7;
      break;
    default:
      break;
  }
  for (int k = 0; k < 3; ++k) p[k] = q[k] + shift[k];
}

static void fill(draw* d, int layout, const double* shift, double* xyz, uint64_t n) {
  for (uint64_t i = 0; i < n; ++i) place(d, layout, i, shift, xyz + 3 * i);
}

typedef struct {
  long double x, y, z;
} wide;
static wide between(const double* from, const double* to) {
  const wide v = {(long double)to[0] - from[0], (long double)to[1] - from[1],
                  (long double)to[2] - from[2]};
  return v;
}
static wide along(wide a, long double s, wide b) {
  const wide v = {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
  return v;
}
static long double product(wide a, wide b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static wide crossed(wide a, wide b) {
  const wide v = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  return v;
}

static long double to_edge(wide p, wide edge) {
  const long double length = product(edge, edge);
  long double s = length > 0 ? product(p, edge) / length : 0;
  s = s < 0 ? 0 : s > 1 ? 1 : s;
  const wide rest = along(p, -s, edge);
  return sqrtl(product(rest, rest));
}

/* Of the point from a triangle: its plane where the foot lies inside, else the nearest edge. */
static long double to_triangle(const double* p, const double* a, const double* b, const double* c) {
  const wide ap = between(a, p), bp = between(b, p), ab = between(a, b), ac = between(a, c),
             bc = between(b, c);
  const wide normal = crossed(ab, ac);
  const long double area = sqrtl(product(normal, normal));
  const wide ca = {-ac.x, -ac.y, -ac.z}, cp = between(c, p);
  if (area > 0 && product(crossed(ab, ap), normal) >= 0 && product(crossed(bc, bp), normal) >= 0 &&
      product(crossed(ca, cp), normal) >= 0)
    return fabsl(product(ap, normal)) / area;
  return fminl(fminl(to_edge(ap, ab), to_edge(bp, bc)), to_edge(ap, ac));
}

/* 1e-12 of the distance; what differences of coordinates of this size hold at all, where it is nothing. */
static void expect_near(double got, long double expected, double extent_m, const char* what,
                        uint64_t seed) {
  const long double error = fabsl((long double)got - expected);
  if (!(error <= 1e-12L * fabsl(expected) + 2.3e-16L * extent_m))
    fail_msg("%s, seed %d: %.17g, by all pairs %.17Lg", what, (int)seed, got, expected);
}

static double extent_of(const double* xyz, uint64_t n) {
  double extent = 0;
  for (uint64_t i = 0; i < 3 * n; ++i) extent = fmax(extent, fabs(xyz[i] - xyz[i % 3]));
  return extent;
}

static void measure(const jalon_comparer* comparer, const jalon_cloud* reference,
                    const jalon_model* model, const double* xyz, double* distance) {
  jalon_cloud* cloud = cloud_of(xyz, kPoints);
  jalon_comparison* comparison = NULL;
  jalon_fields* points = NULL;
  if (model != NULL) MUST(jalon_comparer_run_model(comparer, model, cloud, NULL, &comparison));
  else MUST(jalon_comparer_run(comparer, reference, cloud, NULL, &comparison));
  MUST(jalon_comparison_points(comparison, &points));
  MUST(jalon_fields_copy(points, "distance", JALON_FLOAT64, distance, kPoints));
  jalon_fields_release(points);
  jalon_comparison_release(comparison);
  jalon_cloud_release(cloud);
}

static void between_clouds(const jalon_comparer* comparer, int layout, uint64_t seed) {
  draw d = {seed, 0};
  double reference[3 * kReferences], xyz[3 * kPoints], distance[kPoints];
  const double* shift = grids_m[seed % 3];
  fill(&d, layout, shift, reference, kReferences);
  fill(&d, seed % 2 == 0 ? layout : kBall, shift, xyz, kPoints);
  jalon_cloud* cloud = cloud_of(reference, kReferences);
  measure(comparer, cloud, NULL, xyz, distance);
  jalon_cloud_release(cloud);
  const double extent = extent_of(reference, kReferences) + extent_of(xyz, kPoints);
  for (int i = 0; i < kPoints; ++i) {
    long double least = INFINITY;
    for (int j = 0; j < kReferences; ++j) {
      const wide v = between(reference + 3 * j, xyz + 3 * i);
      least = fminl(least, product(v, v));
    }
    expect_near(distance[i], sqrtl(least), extent, layout_names[layout], seed);
  }
}

/* An octahedron, convex and so with a sign that needs no rule: its axes are drawn, some of them thousands of times
 * as long as others. */
static const uint32_t octahedron[24] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                        2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

static void from_a_solid(const jalon_comparer* comparer, int layout, uint64_t seed) {
  draw d = {seed, 0};
  double xyz[3 * kPoints], distance[kPoints], corners[18] = {0};
  const double* shift = grids_m[seed % 3];
  const double middle[3] = {shift[0] + 5, shift[1] + 5, shift[2] + 5};
  for (int axis = 0; axis < 3; ++axis)
    for (int end = 0; end < 2; ++end) {
      double* corner = corners + 3 * (2 * axis + end);
      const double length = seed % 5 == 0 ? pow(10, 3 * drawn(&d) - 3) * 6 : 1 + 5 * drawn(&d);
      memcpy(corner, middle, sizeof middle);
      corner[axis] += end == 0 ? length : -length;
    }
  fill(&d, layout, shift, xyz, kPoints);
  for (int k = 0; k < 3 && layout >= kLine; ++k) { /* on a corner, and in the middle of an edge */
    xyz[k] = corners[k];
    xyz[3 + k] = 0.5 * (corners[k] + corners[6 + k]);
  }
  jalon_model* model = NULL;
  MUST(jalon_model_create_mesh(corners, JALON_FLOAT64, 6, 0, octahedron, 8, NULL, &model));
  measure(comparer, NULL, model, xyz, distance);
  jalon_model_release(model);
  const double extent = extent_of(corners, 6) + extent_of(xyz, kPoints);
  for (int i = 0; i < kPoints; ++i) {
    long double least = INFINITY, highest = -INFINITY;
    for (int t = 0; t < 8; ++t) {
      const double *a = corners + 3 * octahedron[3 * t], *b = corners + 3 * octahedron[3 * t + 1],
                   *c = corners + 3 * octahedron[3 * t + 2];
      const wide normal = crossed(between(a, b), between(a, c));
      least = fminl(least, to_triangle(xyz + 3 * i, a, b, c));
      highest =
          fmaxl(highest, product(between(a, xyz + 3 * i), normal) / sqrtl(product(normal, normal)));
    }
    const int on_it = least <= 1e-15L * extent; /* of rounded corners: either side */
    expect_near(on_it ? fabs(distance[i]) : distance[i], highest > 0 || on_it ? least : -least,
                extent, layout_names[layout], seed);
  }
}

static void distances__are_those_of_all_pairs_to_1e_12(void** state) {
  (void)state;
  jalon_comparer* comparer = NULL;
  jalon_params* params = NULL;
  MUST(jalon_comparer_create("distance", &comparer));
  MUST(jalon_comparer_params(comparer, &params));
  MUST(jalon_params_set_double(params, "max_distance_m", 1e6));
  int configurations = 0;
  for (uint64_t i = 0; i < kRandom + kDegenerate; ++i, ++configurations) {
    const int layout =
        (int)(i < kRandom ? i / 2 % kLine : kLine + (i - kRandom) / 2 % (kLayouts - kLine));
    if (i % 2 == 0) between_clouds(comparer, layout, i / 2);
    else from_a_solid(comparer, layout, i / 2);
  }
  printf("FIGURE distances: %d configurations as by all pairs\n", configurations);
  jalon_params_release(params);
  jalon_comparer_release(comparer);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(distances__are_those_of_all_pairs_to_1e_12)};
  return cmocka_run_group_tests_name("distances", tests, NULL, NULL);
}
