/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file georeference.h
 * Direct georeferencing: what a mobile scanner measures, its mount and the trajectory make points of the world, each
 * with its covariance.
 *
 *     u(theta, phi) = (cos theta sin phi, sin theta sin phi, cos phi)    scanner frame
 *     P = R (R_c (P0 + r u) + a) + T                                     world
 *
 * r: range, theta and phi: angles of the beam; P0: mirror offset, R_c: boresight rotation, a: lever arm (options); R
 * and T: attitude and position of the vehicle at the time of the return (jalon/trajectory.h says what roll, pitch and
 * yaw mean). The covariance follows from the 18 inputs by linear propagation, C = J diag(sigma^2) J^T, all of them
 * independent (Glennie 2007; Monnier 2014).
 */
#ifndef JALON_GEOREFERENCE_H
#define JALON_GEOREFERENCE_H

#include <jalon/cloud.h>
#include <jalon/model.h>
#include <jalon/trajectory.h>

JALON_BEGIN_C

/**
 * A cloud of count returns, in their order. O(n), parallel; same bits whatever the threads.
 *
 * - times_s: of the returns, within the trajectory; fastest where they ascend.
 * - ranges_m: > 0.
 * - thetas_rad: about the scanner's z axis, from x towards y.
 * - phis_rad: from the scanner's z axis.
 * - options: operation "georeference": mirror_offset_m, boresight_rad (roll, pitch, yaw of the scanner in the vehicle's
 *   frame) with boresight_order "zyx" (R_c = Rz Ry Rx) or "xyz" (Rx Ry Rz), lever_arm_m; the standard deviations of
 *   range, angles, mirror offset, boresight and lever arm, those of attitude and position coming from the trajectory;
 *   "covariances" = false without.
 *
 * The CRS is the trajectory's. Fields; the last two with "covariances":
 *     column          type         unit  meaning
 *     time            float64      s     of the return
 *     beam_origin     float64 x 3  m     the laser's centre, R (R_c P0 + a) + T
 *     beam_direction  float32 x 3  1     unit, R R_c u
 *     covariance      float32 x 6  m2    xx, xy, xz, yy, yz, zz, as jalon_cloud_compute_covariances
 *                                        gives them: the comparer "m3c2" takes them
 *     point_sigma     float32      m     root of the sum of the variances
 *
 * JALON_ERROR_INVALID_ARGUMENT naming a return with an impossible range or angle or a time outside of the trajectory,
 * or saying which sigmas the trajectory lacks.
 */
JALON_API JALON_CHECK jalon_status jalon_trajectory_georeference(
    const jalon_trajectory* trajectory, const double* times_s, const double* ranges_m,
    const double* thetas_rad, const double* phis_rad, uint64_t count, const jalon_params* options,
    jalon_task* task, jalon_cloud** out);

/**
 * Uncertainty ellipsoids of points, a mesh: around every "every"-th point that holds the truth with probability
 * "confidence". Half-axes: sqrt(q lambda) e of the eigenvalues and vectors of the covariance, q the quantile of
 * chi-square with 3 degrees of freedom (11.345 for 0.99), times "scale". Triangles look outward; the id of each
 * ("face" of jalon_model_triangles) is the index of its point.
 *
 * - cloud: with the field "covariance", 6 components (xx, xy, xz, yy, yz, zz) or 9; JALON_ERROR_NOT_FOUND without.
 *   Points whose covariance is not finite get none.
 * - options: operation "ellipsoids".
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_ellipsoids(const jalon_cloud* cloud,
                                                          const jalon_params* options,
                                                          jalon_task* task, jalon_model** out);

JALON_END_C

#endif
