/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file field_tools.h
 * What the values of a field say: their histogram and noise law, which points have changed, and tools that make fields
 * from fields (Girardeau-Montaut 2006, chapter 3).
 *
 * The usual chain after a comparison: cut out a zone where nothing has changed, fit a noise law to its "distance"
 * (jalon_noise_law_fit), test every neighbourhood of the whole cloud against it (jalon_cloud_compute_chi_square), and
 * group the points that have changed (jalon_cloud_compute_components with field = "changed").
 *
 * field names a field of one component on the cloud. Values that are not finite are no values: such points take no part
 * in any neighbourhood and get NaN (or the documented number) themselves. Functions that change a cloud add the field
 * whose name their options say, or replace it. options may be NULL for the defaults; lengths that are 0 there are
 * taken from the mean spacing of the points: JALON_ERROR_INSUFFICIENT_DATA where there are fewer than 8, or most of
 * them coincide. Results have the same bits for any number of threads. Common errors: JALON_ERROR_NOT_FOUND for an
 * unknown field, JALON_ERROR_INVALID_ARGUMENT for one of several components.
 */
#ifndef JALON_FIELD_TOOLS_H
#define JALON_FIELD_TOOLS_H

#include <jalon/cloud.h>

JALON_BEGIN_C

/* ---- noise laws ---- */

/**
 * How deviations scatter where nothing has changed. Immutable; may be used by many threads. Kept as JSON text it serves
 * again for data of the same instrument under the same conditions.
 */
typedef struct jalon_noise_law jalon_noise_law;

/**
 * Fits a law to all values of the field by maximum likelihood. Operation "noise_law": law weibull (a / b) ((x - x0) /
 * b)^(a - 1) exp(-((x - x0) / b)^a), for distances without sign, with x0 = 0 or, with shift = true, estimated too
 * (Hirose 1996); gauss, for signed ones; empirical: up to 4 096 quantiles of the sample itself. A Weibull law leaves
 * out values that are not above x0. JALON_ERROR_INSUFFICIENT_DATA below 9 values, JALON_ERROR_DEGENERATE when they are
 * all equal, or not above 0 by half for a Weibull law. O(n), O(n log n) with shift or empirical.
 */
JALON_API JALON_CHECK jalon_status jalon_noise_law_fit(const jalon_cloud* cloud, const char* field,
                                                       const jalon_params* options,
                                                       jalon_task* task, jalon_noise_law** out);
/**
 * From JSON text: {"law": "weibull", "shape": 1.9, "scale": 0.004, "shift": 0}, {"law": "gauss", "mean": 0, "sigma":
 * 0.003} or {"law": "empirical", "quantiles": [...]}, with "samples", "chi_square" and "classes" where they are known.
 */
JALON_API JALON_CHECK jalon_status jalon_noise_law_from_json(const char* json,
                                                             jalon_noise_law** out);
/** The law as JSON text, which jalon_noise_law_from_json reads back to the same law. Lives as long as the law. */
JALON_API JALON_CHECK jalon_status jalon_noise_law_json(const jalon_noise_law* law,
                                                        const char** out);
/**
 * One row; numbers without a unit have that of the field.
 *     column              type     unit  meaning
 *     kind                uint8    -     0 Gauss, 1 Weibull, 2 empirical
 *     mean                float64  -     of the law (3.5)
 *     standard_deviation  float64  -     of the law (3.6)
 *     shape               float64  1     a; NaN where there is none, as the next four
 *     scale               float64  -     b; sigma for Gauss
 *     shift               float64  -     x0
 *     shape_sigma         float64  1     standard deviation of the estimate
 *     scale_sigma         float64  -     standard deviation of the estimate
 *     samples             uint64   -     values that it was fitted to
 *     chi_square          float64  1     distance to its own sample
 *     classes             uint32   -     equally probable classes of that distance
 */
JALON_API JALON_CHECK jalon_status jalon_noise_law_table(const jalon_noise_law* law,
                                                         jalon_fields** out);
/** Probability density and P(X <= x) at count values. Each output has count elements and may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_noise_law_evaluate(const jalon_noise_law* law,
                                                            const double* values, uint64_t count,
                                                            double* density, double* cumulative);
/** The values that the law does not exceed with these probabilities; NaN for probabilities outside 0 ... 1. */
JALON_API JALON_CHECK jalon_status jalon_noise_law_quantiles(const jalon_noise_law* law,
                                                             const double* probabilities,
                                                             uint64_t count, double* out);
JALON_API jalon_noise_law* jalon_noise_law_retain(jalon_noise_law* law);
JALON_API void jalon_noise_law_release(jalon_noise_law* law);

/* ---- looking at one field ---- */

/**
 * Are values a normal sample? Shapiro & Wilk's test (1965) with the p-value of Royston (1995, AS R94), and what the
 * sample looks like. Values that are not finite are left out. O(n log n).
 *
 * - options: operation "normality": "alpha"; of more values than "most" (5000) so many are drawn for the test by
 *   "seed".
 *
 * One row; numbers without a unit have that of the values:
 *     column              type     unit    meaning
 *     values              uint64   values  finite ones
 *     mean                float64  -       of all values
 *     median              float64  -       half of the values are not above it
 *     standard_deviation  float64  -       about the mean, divided by n - 1
 *     variance            float64  -       its square
 *     range               float64  -       largest less least
 *     quartile_range      float64  -       third quartile less first
 *     skewness            float64  1       G1, without bias for normal samples
 *     kurtosis            float64  1       G2, in excess of the normal law's
 *     tested              uint64   values  in the test
 *     W                   float64  1       Shapiro and Wilk's; near 1 for a normal sample
 *     p                   float64  1       probability of such a W or a lesser one for a normal sample
 *     is_normal           uint8    -       1: p is above alpha, the sample may be normal
 *
 * JALON_ERROR_INSUFFICIENT_DATA below 3 values, JALON_ERROR_DEGENERATE where all are equal.
 */
JALON_API JALON_CHECK jalon_status jalon_normality(const double* values, uint64_t count,
                                                   const jalon_params* options, jalon_fields** out);
/** The same of a field of one component: one row with the columns of jalon_normality. */
JALON_API JALON_CHECK jalon_status jalon_cloud_field_normality(const jalon_cloud* cloud,
                                                               const char* field,
                                                               const jalon_params* options,
                                                               jalon_task* task,
                                                               jalon_fields** out);

/**
 * Histogram of a field. JALON_ERROR_INSUFFICIENT_DATA when there is no value. O(n log n).
 *
 * - law: adds the columns that say so; may be NULL.
 * - options: operation "histogram": "bins", "minimum" and "maximum", "classes".
 * - bins, summary: each may be NULL.
 *
 * bins, one row a bin; numbers without a unit have that of the field:
 *     column    type     unit    meaning
 *     from      float64  -       lower end
 *     to        float64  -       upper end
 *     count     uint64   points  values in it
 *     expected  float64  points  with a law: the same by it
 *
 * summary, one row:
 *     column              type     unit    meaning
 *     values              uint64   points  finite ones
 *     missing             uint64   points  without a value
 *     below               uint64   points  below the first bin
 *     above               uint64   points  above the last bin
 *     minimum             float64  -       least value
 *     maximum             float64  -       largest value
 *     mean                float64  -       of all values
 *     standard_deviation  float64  -       about the mean, divided by n
 *     rms                 float64  -       about 0
 *     median              float64  -       half of the values are not above it
 *     p90                 float64  -       90 % are not above it
 *     p95                 float64  -       95 %
 *     p99                 float64  -       99 %
 *     chi_square          float64  1       with a law: its global chi-square distance to the
 *                                          field's values (3.1) over equally probable classes
 *     degrees_of_freedom  uint32   -       with a law: classes - 1
 *     p_value             float64  1       with a law: of such a distance or a larger one
 *     kolmogorov          float64  1       with a law: the largest difference of the cumulatives
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_field_histogram(
    const jalon_cloud* cloud, const char* field, const jalon_noise_law* law,
    const jalon_params* options, jalon_task* task, jalon_fields** bins, jalon_fields** summary);

/* ---- which points have changed ---- */

/**
 * Local statistical filter: the n values around each point against the law, by chi-square over
 * sqrt(n) classes (3.1) or Kolmogorov-Smirnov. JALON_ERROR_INSUFFICIENT_DATA below 9 values in all.
 * O(n log n), parallel.
 *
 * - options: operation "chi_square": "method", "neighbours" (16) or "radius_m", "error_margin" p,
 *   "classes" equiprobable | relaxed, "threshold" tabulated (upper tail of chi-square at p, 3.2 as
 *   it is meant) | empirical | given, "passes", "one_sided".
 *
 * Fields:
 *     column      type     unit  meaning
 *     chi_square  float64  1     distance from the law; "kolmogorov" for that method
 *     changed     uint8    -     1 where the distance is above the cut
 *
 * summary, one row:
 *     column       type     unit    meaning
 *     tested       uint64   points  with enough values around
 *     not_tested   uint64   points  without
 *     second_pass  uint64   points  tested again with more neighbours
 *     changed      uint64   points  above the cut
 *     threshold    float64  1       the cut
 *     ceiling      float64  1       where distances saturate; infinite where they do not
 *
 * Distances of tests with other numbers of classes (the second pass, balls) are brought to the
 * scale of the first pass by the ratio of their tabulated cuts, so that one cut serves the whole
 * field. With equally probable classes they saturate at n (sqrt(n) - 1). Where fewer than 9 values
 * are around a point it is not tested: NaN, not changed. On pure noise a share p of the
 * neighbourhoods is flagged; since neighbours share values, false alarms come in clumps: leave out
 * small components.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_compute_chi_square(
    jalon_cloud* cloud, const char* field, const jalon_noise_law* law, const jalon_params* options,
    jalon_task* task, jalon_fields** summary);
/**
 * Groups by value: field "class" (uint8: 0 below the cut, 1 above it, 2 above a second cut, 255 no
 * value). Operation "classes": "method" two_means, the cut that leaves the least squares about the
 * means of two groups, exactly; or thresholds, at "low" and "high". two_means:
 * JALON_ERROR_INSUFFICIENT_DATA below 2 values, JALON_ERROR_DEGENERATE when all are equal. O(n log
 * n).
 *
 * summary, one row; numbers without a unit have that of the field:
 *     column    type     unit    meaning
 *     low_cut   float64  -       between groups 0 and 1
 *     high_cut  float64  -       between groups 1 and 2; infinite: none
 *     centre_0  float64  -       mean of group 0; NaN for an empty one
 *     centre_1  float64  -       of group 1
 *     centre_2  float64  -       of group 2
 *     count_0   uint64   points  of group 0
 *     count_1   uint64   points  of group 1
 *     count_2   uint64   points  of group 2
 *     missing   uint64   points  without a value
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_classify_field(jalon_cloud* cloud, const char* field,
                                                              const jalon_params* options,
                                                              jalon_task* task,
                                                              jalon_fields** summary);

/* ---- fields from fields ---- */

/**
 * Gradient of the field along the surface: field "gradient" (float32, its norm; per metre) and, where vector_name is
 * set, the gradient itself (float32 x 3). Operation "gradient": method thesis, the mean of PP_i / |PP_i|^2 (f_i - f)
 * over the ball of radius_m (3.9), which is half the slope on a surface; corrected, twice that; least_squares, slopes
 * over the tangent plane. NaN where no other point is in the ball. O(n m) for m points a ball, parallel.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_compute_gradient(jalon_cloud* cloud,
                                                                const char* field,
                                                                const jalon_params* options,
                                                                jalon_task* task);
/**
 * What neighbourhoods make of the field: field "filtered" (float64). Operation "field_filter": method gaussian, the
 * mean with weights exp(-d^2 / (2 sigma^2)) (3.10); mean, median, minimum or maximum of a ball or of k points.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_filter_field(jalon_cloud* cloud, const char* field,
                                                            const jalon_params* options,
                                                            jalon_task* task);
/**
 * Arithmetic point by point: field "computed" (float64), of field and other, or of field and the option constant where
 * other is NULL. Operation "field_arithmetic": operation add, subtract, multiply, divide, minimum, maximum, power,
 * absolute, negate, sqrt, square, exp, log, log10, dot (scalar product over the components), norm. Fields may have
 * several components; other must have as many, or one. What is not defined is NaN.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_compute_field(jalon_cloud* cloud, const char* field,
                                                             const char* other,
                                                             const jalon_params* options,
                                                             jalon_task* task);

/* ---- fronts ---- */

/**
 * Distance along the surface from the nearest of count seeds (indices of points): field "geodesic" (float64, m; NaN
 * where the front does not come), by fast marching over the occupied cells of a grid (Sethian 1996; Memoli & Sapiro
 * 2001). Operation "geodesic": cell_m, max_distance_m. The front crosses no gap wider than two cells. Error, with some
 * nine points a cell: below 1.5 %, root mean square 0.6 %, beyond ten cells from the seed on planes and cylinders.
 * JALON_ERROR_INSUFFICIENT_DATA without seeds. O(n + c log c) for c cells.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_compute_geodesic(jalon_cloud* cloud,
                                                                const uint64_t* seeds,
                                                                uint64_t count,
                                                                const jalon_params* options,
                                                                jalon_task* task);
/**
 * Segmentation by gradient-constrained propagation (3.3.2): from the largest deviation left, a
 * front spreads over the occupied cells with the speed exp(alpha (g_j - g_i)) of the gradient g and
 * ends where its next arrival takes too long; what it took is one region; and so on while
 * deviations are above "minimum_seed". Adds the field "region" (uint32, 1 = most points, 0 = none).
 * O(n log n).
 *
 * - field: deviations; gradient_field: norms, smoothed or not.
 * - options: operation "propagation": "cell_m", "alpha", "scope" front | step, "jump",
 *   "minimum_seed", "min_points", "arrival_name".
 *
 * JALON_ERROR_INSUFFICIENT_DATA when no point has both values; JALON_ERROR_DEGENERATE when all
 * deviations are equal and minimum_seed is 0.
 *
 * regions, one row a region; arrival times are in m at speed 1:
 *     column          type     unit    meaning
 *     label           uint32   -       number of the region
 *     points          uint64   points  of the region
 *     cells           uint64   -       of the region
 *     seed            uint64   -       index of the point that it grew from
 *     seed_deviation  float64  -       deviation there, in the field's unit
 *     last_arrival    float64  m       of its last cell
 *     next_arrival    float64  m       of the cell that the front ended at; infinite: nothing was
 *                                      left
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_segment_propagation(
    jalon_cloud* cloud, const char* field, const char* gradient_field, const jalon_params* options,
    jalon_task* task, jalon_fields** regions);

/* ---- distances by a grid ---- */

/**
 * Distance from the reference by a distance transform of a grid around both clouds: field "map_distance" (float64, m),
 * a preview whose time does not depend on how far the clouds are apart. Operation "distance_map": method chamfer, <3,
 * 4, 5> thirds of a cell from the occupied cells (Borgefors 1984; up to 12 % of the distance and the diagonal of a cell
 * off); fast_marching, read between the cells' centres (off by about a cell); cell_m, max_distance_m (beyond: NaN).
 * JALON_ERROR_INSUFFICIENT_DATA for an empty reference, JALON_ERROR_LIMIT above 2^27 cells or 20 000 along an axis.
 * O(n + c), O(n + c log c) for c cells.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_compute_map_distance(jalon_cloud* cloud,
                                                                    const jalon_cloud* reference,
                                                                    const jalon_params* options,
                                                                    jalon_task* task);
/**
 * The map itself: the centres of all cells around the cloud, with the field "map_distance" (float32, m); those beyond
 * max_distance_m are left out. Operation and errors as above.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_distance_map(const jalon_cloud* cloud,
                                                            const jalon_params* options,
                                                            jalon_task* task, jalon_cloud** out);

JALON_END_C

#endif
