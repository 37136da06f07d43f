/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file primitives.h
 * Spheres, circles and cylinders fitted to points; segments picked by hand.
 *
 * Points are given by their indices in a cloud (count = 0: all of it); points from elsewhere become
 * a cloud first. Picks are coordinates in the cloud's frame, near the surface rather than on it.
 * Options are of operation "primitive" (fits) or "pick"; NULL = defaults.
 */
#ifndef JALON_PRIMITIVES_H
#define JALON_PRIMITIVES_H

#include <jalon/segmenter.h>

JALON_BEGIN_C

/* ---- fits ---- */

/**
 * Sphere: one row with the columns of jalon_segmentation_segments. From 4 points on; 4 points give
 * it exactly, without a covariance.
 *
 * Robust (default): a start by random draws of 4 points, then Gauss-Newton with Tukey's biweight on
 * the points within "tolerance_m". The covariance (Huber's sandwich) is honest with some outliers
 * and with noise that differs from point to point: with 3 mm of noise and 5 % outliers the 95 %
 * ellipsoid of centre and radius covers the truth in 93 to 97 %, all round or seen from one side.
 * Noise that is the same in all directions makes a radius r too large by sigma^2 / r (a cylinder's
 * by half of that). Not robust: least squares on every point, covariance sigma^2 (J^T J)^-1.
 * Boulaassal 2010, E.1.1; Schnabel et al. 2007. O(n) an iteration.
 *
 * JALON_ERROR_INSUFFICIENT_DATA for too few points; JALON_ERROR_DEGENERATE when they are flat,
 * straight or equal, when the standard deviation of the radius exceeds half of it, or when it lies
 * outside "min_radius_m" to "max_radius_m".
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_fit_sphere(const jalon_cloud* cloud,
                                                          const uint64_t* indices, uint64_t count,
                                                          const jalon_params* options,
                                                          jalon_task* task, jalon_fields** out);
/**
 * Cylinder: one row as above. direction: of its axis, e.g. (0, 0, 1) for a column, any length; then
 * 3 points are enough. NULL = free: the start is drawn from pairs of points with normals (the field
 * "normal", else planes through "k" neighbours), all five unknowns are adjusted, and 5 points are
 * needed. Boulaassal 2010, E.1.2; Schnabel et al. 2007. Errors as above.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_fit_cylinder(const jalon_cloud* cloud,
                                                            const uint64_t* indices, uint64_t count,
                                                            const jalon_vec3* direction,
                                                            const jalon_params* options,
                                                            jalon_task* task, jalon_fields** out);
/**
 * Circle in the least-squares plane of the points, from 3 on. Errors as above. One row:
 *     column      type          unit    meaning
 *     centre      float64 x 3   m       of the circle
 *     normal      float64 x 3   -       of its plane
 *     radius      float64       m       of the circle
 *     sigma       float64       m       of the points from it, in the plane
 *     inliers     uint64        points  that carry it
 *     covariance  float64 x 16  -       of centre and radius, row-major, rank 3
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_fit_circle(const jalon_cloud* cloud,
                                                          const uint64_t* indices, uint64_t count,
                                                          const jalon_params* options,
                                                          jalon_task* task, jalon_fields** out);

/* ---- segments picked by hand (Boulaassal 2010, 5.5.2) ---- */

/** A segmentation of the cloud without segments: every point remains to be picked. */
JALON_API JALON_CHECK jalon_status jalon_segmentation_start(const jalon_cloud* cloud,
                                                            jalon_task* task,
                                                            jalon_segmentation** out);
/**
 * A new segmentation with one segment more, its last row; the one given stays as it was and is the
 * undo. The two share the cloud; a new one costs 9 bytes a point. Members are points of label 0
 * within "tolerance_m" of the surface; they are found, fitted by least squares and found again
 * until they stay the same; connected pieces smaller than "min_area_m2" are left out. O(n) a round.
 *
 * picks: count times x, y, z. How many, by primitive:
 * - JALON_PRIMITIVE_PLANE: 1 pick is a seed, from which the plane grows over gaps of at most
 *   "gap_m"; 3 picks or more bound it: the members lie inside their polygon, in their order, or in
 *   their convex hull where the order crosses itself.
 * - JALON_PRIMITIVE_SPHERE: 4 picks or more, or 2 with the normals of the points around; it grows
 *   around them.
 * - JALON_PRIMITIVE_CYLINDER: 3 picks or more of a vertical one, or 2 with normals of any other; it
 *   grows around them.
 *
 * JALON_ERROR_INSUFFICIENT_DATA for too few picks, when a seed or a normal finds fewer than 3
 * points, when a seed lies farther than "gap_m" from all points or amid points that are taken, or
 * when the picks gather fewer than "min_points"; JALON_ERROR_DEGENERATE when they fix no surface:
 * flat for a sphere or a cylinder, or the points around them equal or collinear.
 */
JALON_API JALON_CHECK jalon_status jalon_segmentation_pick(
    const jalon_segmentation* segmentation, int32_t primitive, const double* picks, uint64_t count,
    const jalon_params* options, jalon_task* task, jalon_segmentation** out);
/** The points of label 0 with their fields, as a new cloud. */
JALON_API JALON_CHECK jalon_status jalon_segmentation_remaining(
    const jalon_segmentation* segmentation, jalon_task* task, jalon_cloud** out);
/**
 * Writes the segments as text, a row each: 1 nx ny nz offset (plane), 2 x y z radius (sphere,
 * centre), 3 x y z dx dy dz radius (cylinder, point and direction of the axis). Numbers come back
 * to the same bits.
 */
JALON_API JALON_CHECK jalon_status
jalon_segmentation_write_primitives(const jalon_segmentation* segmentation, const char* path);

JALON_END_C

#endif
