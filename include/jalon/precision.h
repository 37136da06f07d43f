/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file precision.h
 * What measured points are worth: the error budget of a laser scanner, from its specification to the covariance of a
 * point and of a plane; and the field tests of a range finder.
 *
 * Scanner frame: Z along the vertical axis, h clockwise from +Y, v upward from the horizon: X = d cos v sin h, Y = d
 * cos v cos h, Z = d sin v (Boulaassal 2010, 5.4). Independent influences add up as s = sqrt(sum s_i^2) (Baltsavias
 * 1999). Options are of operation "precision" (the defaults are a Trimble GX: 7 mm, 60 and 70 urad); NULL = defaults.
 */
#ifndef JALON_PRECISION_H
#define JALON_PRECISION_H

#include <jalon/segmenter.h>

JALON_BEGIN_C

/**
 * The budget of count points, one row a point.
 *
 * - ranges_m: m, > 0.
 * - vertical_rad: vertical angles; NULL: 0.
 * - incidence_rad: angles between ray and surface normal; NULL: 0.
 * - options: operation "precision".
 *
 * Standard deviations, but for the last two:
 *     column      type         unit  meaning
 *     range       float64      m     sigma_range_m + range_ppm
 *     horizontal  float64      m     d cos v s_h
 *     vertical    float64      m     d s_v
 *     instrument  float64      m     these three together (5.6; 11.6 mm at 100 m with the defaults)
 *     pulse       float64      m     0.35 c / (2 b SNR sqrt(n)) (Koskinen et al. 1991)
 *     beam        float64      m     d gamma / 4, in each direction across the ray (Lichti & Gordon
 *                                    2004)
 *     azimuth     float64      m     d cos v sqrt(2) s_hor / d_BS
 *     levelling   float64      m     0.2 nu sqrt(d^2 + Z^2)
 *     station     float64      m     position and instrument height (Scaioni 2005)
 *     point       float64      m     all of it
 *     covariance  float64 x 9  m2    row-major, of the point at h = 0 in the scanner frame: J
 *                                    diag(s_d^2, s_v^2, s_h^2) J^T and the other influences (5.5
 *                                    with sin v in the last line, where the thesis prints cos v)
 *     range_bias  float64      m     what shifts the range, in none of the others: time walk c
 *                                    t_rise k (1 - 1/a) (Moring et al. 1989), temperature drift
 *                                    (Maatta et al. 1993)
 *     intensity   float64      1/m2  rho cos^p(beta) exp(-gamma R) / R^2 (Hancock 1999; Rueger
 *                                    1990)
 *
 * JALON_ERROR_INVALID_ARGUMENT for a range that is not positive, or an angle beyond a right one.
 */
JALON_API JALON_CHECK jalon_status jalon_precision_budget(
    const double* ranges_m, const double* vertical_rad, const double* incidence_rad, uint64_t count,
    const jalon_params* options, jalon_fields** out);

/**
 * What the budget above makes of each point at its place as its station saw it. Incidence angles
 * come from the field "normal" where there is one. Every point needs a station with a pose, away
 * from it: else JALON_ERROR_INVALID_ARGUMENT naming the first. O(n), parallel.
 *
 * Fields:
 *     column       type         unit  meaning
 *     covariance   float32 x 6  m2    xx, xy, xz, yy, yz, zz in the cloud's frame
 *     point_sigma  float32      m     root of the sum of the variances
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_compute_covariances(jalon_cloud* cloud,
                                                                   const jalon_params* options,
                                                                   jalon_task* task);

/**
 * Planes adjusted with what their points are worth: weighted least squares with 1 / (n^T C n) for
 * weights. What all points of a station share (its position, back-sight, level) does not average
 * out and is left out. Stations as above. O(n), parallel.
 *
 * One row a segment; NaN for segments that are no planes:
 *     column           type          unit  meaning
 *     label            uint32        -     of the segment
 *     normal           float64 x 3   1     unit length
 *     offset           float64       m     normal . p = offset
 *     covariance       float64 x 16  -     of normal and offset, row-major: N^-1, from the points'
 *                                          covariances; beside it stands the empirical one of
 *                                          jalon_segmentation_segments
 *     sigma_prior      float64       m     of the points along the normal, from the scanner
 *     sigma            float64       m     of the points from the plane, as measured
 *     variance_factor  float64       1     residuals against the scanner's sigmas: 1 where the
 *                                          budget is right
 */
JALON_API JALON_CHECK jalon_status jalon_segmentation_plane_covariances(
    const jalon_segmentation* segmentation, const jalon_params* options, jalon_task* task,
    jalon_fields** out);

/**
 * Range precision on a sample of one material (5.7): the mean plane of the points with these
 * indices (count = 0: all of the cloud). JALON_ERROR_INSUFFICIENT_DATA below 3 points,
 * JALON_ERROR_DEGENERATE for collinear ones.
 *
 * One row:
 *     column           type         unit    meaning
 *     points           uint64       points  of the sample
 *     range_precision  float64      m       s_d = sqrt(sum d_i^2 / (n - 1))
 *     sigma            float64      m       the same divided by n - 3
 *     normal           float64 x 3  1       of the mean plane
 *     offset           float64      m       normal . p = offset
 *     mean_intensity   float64      -       of the field "intensity"; NaN without
 *     std_intensity    float64      -       divided by n - 1
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_range_precision(const jalon_cloud* cloud,
                                                               const uint64_t* indices,
                                                               uint64_t count, jalon_task* task,
                                                               jalon_fields** out);

/**
 * The additive constant of a range finder from a baseline (5.4.1): count measured distances m and
 * the known ones L (m). JALON_ERROR_INSUFFICIENT_DATA for none.
 *
 * One row:
 *     column          type     unit  meaning
 *     distances       uint64   -     of the baseline
 *     constant        float64  m     k = mean(m - L): measured ranges are too long by k; corrected:
 *                                    m - k
 *     sigma           float64  m     precision, about the mean, n - 1
 *     sigma_constant  float64  m     sigma / sqrt(n)
 *     rms             float64  m     accuracy before the correction, about 0
 */
JALON_API JALON_CHECK jalon_status jalon_baseline_constant(const double* measured_m,
                                                           const double* known_m, uint64_t count,
                                                           jalon_fields** out);

/**
 * Angular precision from pairs of spheres side by side at one range (5.3.1; Boehler & Marbs 2005):
 * their measured and known distances and that range (m), count of each. Range errors along the rays
 * do not enter. Errors as above; JALON_ERROR_INVALID_ARGUMENT for a range that is not positive.
 *
 * One row, of the angular errors (m - L) / R:
 *     column  type     unit  meaning
 *     pairs   uint64   -     of spheres
 *     mean    float64  rad   mean error
 *     std     float64  rad   about the mean, n - 1
 *     rms     float64  rad   about 0
 */
JALON_API JALON_CHECK jalon_status jalon_angular_precision(const double* measured_m,
                                                           const double* known_m,
                                                           const double* ranges_m, uint64_t count,
                                                           jalon_fields** out);

/**
 * Range D (m) from phase differences (annex A.4): count wavelengths (m) and the remainders of 2D on each (0 ...
 * wavelength). Wavelengths close to each other (the longest below twice the shortest): by their beats, unambiguous up
 * to half the longest beat; m = (dl2 - dl1) / (lambda1 - lambda2), where the thesis prints the other sign. Nested ones:
 * coarse to fine, unambiguous up to half the longest. The result is the mean over all wavelengths.
 * JALON_ERROR_INVALID_ARGUMENT for wavelengths that are not positive or equal, or a remainder outside its wavelength.
 */
JALON_API JALON_CHECK jalon_status jalon_phase_range(const double* wavelengths_m,
                                                     const double* remainders_m, uint64_t count,
                                                     double* out);

JALON_END_C

#endif
