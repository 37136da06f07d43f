/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file targets.h
 * Targets measured in a cloud: spheres and flat ones, with the covariances that jalon_registrar_run_targets weights
 * them with. Options are of operation "target"; NULL = defaults.
 */
#ifndef JALON_TARGETS_H
#define JALON_TARGETS_H

#include <jalon/registrar.h>

JALON_BEGIN_C

/** How a target was measured; 0 = not at all. */
enum {
  JALON_TARGET_SPHERE = 1,
  JALON_TARGET_CHECKER = 2, /**< the point where four quadrants, dark and bright by turns, meet */
  JALON_TARGET_DISC = 3, /**< centre of a disc that is brighter or darker than what surrounds it */
  JALON_TARGET_PATCH = 4 /**< centre of a plate */
};

/** What a target is that a catalogue was searched for. */
enum {
  JALON_RECOGNISED_KNOWN = 1, /**< one entry fits, with the confidence asked for: its code holds */
  JALON_RECOGNISED_AMBIGUOUS = 2, /**< two entries, or two readings of the pattern, fit: no code */
  JALON_RECOGNISED_FOREIGN = 3,   /**< a target of a kind and size that no entry has */
  JALON_RECOGNISED_UNCERTAIN = 4  /**< may be a target, or this entry, but not surely enough */
};

/**
 * Measures the targets near count places (x, y, z each, in the cloud's frame; within "search_m" of
 * the whole target). JALON_ERROR_INVALID_ARGUMENT for places that are not finite. O(points around
 * the places).
 *
 * One row a place, in their order:
 *     column        type         unit  meaning
 *     status        int32        -     JALON_OK; JALON_ERROR_INSUFFICIENT_DATA, fewer than
 *                                      "min_points" points; JALON_ERROR_DEGENERATE, no such target
 *                                      there: then NaN in the rest
 *     kind          uint8        -     JALON_TARGET_...; 0 = not measured
 *     centre        float64 x 3  m     of the target
 *     covariance    float64 x 9  m2    row-major, of the centre: the covariance of a jalon_target
 *     radius        float64      m     of a sphere or disc
 *     radius_sigma  float64      m     its standard deviation; 0: given
 *     normal        float64 x 3  -     of a flat one
 *     sigma         float64      m     of the points from the surface
 *     points        uint64       -     that carry it
 *
 * Spheres ("kind" = sphere): random draws, then least squares with Tukey's biweight on the points
 * within "tolerance_m" of it, with "radius_m" given or free. Noise along the rays would put the
 * centre nearer to the scanner (0.2 mm for 2 mm of noise, a radius of 72 mm and one side seen): its
 * expectation is taken off, with the rays to the stations of the cloud, else along the axis of the
 * cap that is seen. Over 1000 scans of a sphere by the virtual scanner the 95 % ellipsoid of the
 * centre covers the truth in 93 to 97 %. A cap of less than 40 degrees is no sphere: a wall touches
 * any.
 *
 * Flat targets ("kind" = flat): a plane, in it the centre of the "pattern" of "size_m" that the
 * field "intensity_field" shows, by least squares on the brightness with its covariance by White
 * (1982), on the safe side where edges are sharper than the points are apart; along the normal that
 * of the plane. Without a pattern, the centre of the plate's outline when it ends within
 * "search_m", to half a point spacing.
 *
 * With a "catalogue" (kinds, sizes and codes of the targets that were put up) count is 0 and the
 * whole cloud is searched for checkers and discs by the field "intensity_field": JALON_ERROR_NOT_FOUND
 * without it, JALON_ERROR_INSUFFICIENT_DATA where it is the same everywhere. A row a target found,
 * facade by facade, all with status JALON_OK; O(points). Further columns:
 *     size                float64  m   edge of the checker, diameter of the disc
 *     size_sigma          float64  m   its standard deviation
 *     verdict             uint8    -   JALON_RECOGNISED_...
 *     entry               int32    -   of the catalogue, from 0, that fits best; -1: none
 *     second              int32    -   another that may be meant; -1: none
 *     confidence          float64  1   chance that it is this entry; without one, that it is a target
 *     pattern_confidence  float64  1   chance that it is a target
 *     misfit              float64  1   share of the brightness that pattern, ground and noise leave
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_measure_targets(const jalon_cloud* cloud,
                                                               const double* places, uint64_t count,
                                                               const jalon_params* options,
                                                               jalon_task* task,
                                                               jalon_fields** out);

JALON_END_C

#endif
