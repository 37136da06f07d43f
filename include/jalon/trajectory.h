/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file trajectory.h
 * Trajectories of mobile mapping: times, poses, and what each epoch is worth. Immutable; readable by many threads.
 *
 * World: a projected or local system, x east, y north, z up, metres. The parameter "axes" of operation "trajectory"
 * says how roll, pitch and yaw make the rotation R from the vehicle to the world:
 *
 * - "enu": the vehicle's x forward, y left, z up; R = Rz(yaw) Ry(pitch) Rx(roll); yaw anticlockwise from east.
 * - "ned": the vehicle's x forward, y right, z down; R = N Rz(yaw) Ry(pitch) Rx(roll) with N from north, east, down to
 *   east, north, up; yaw is the heading, clockwise from grid north (Applanix, SBET).
 *
 * Rx, Ry, Rz are right-handed; the vehicle's frame is that of the inertial unit, its origin the position of the
 * epochs.
 */
#ifndef JALON_TRAJECTORY_H
#define JALON_TRAJECTORY_H

#include <jalon/fields.h>
#include <jalon/params.h>
#include <jalon/task.h>

JALON_BEGIN_C

typedef struct jalon_trajectory jalon_trajectory;

/**
 * From arrays; everything is copied. O(n). Times out of order, numbers that are not finite and sigmas that are not
 * positive are JALON_ERROR_INVALID_ARGUMENT with a line that names epoch and field; fewer than two epochs
 * JALON_ERROR_INSUFFICIENT_DATA.
 *
 * - times_s: count of them, ascending.
 * - positions_m: count x 3.
 * - attitudes_rad: count x 3: roll, pitch, yaw.
 * - position_sigmas_m, velocity_sigmas_m_s, attitude_sigmas_rad: count x 3 standard deviations, along x, y, z or of
 *   roll, pitch, yaw; NULL: not known.
 * - crs: CRS text of the positions (WKT, a URN, ...); NULL: not known.
 * - options: operation "trajectory": "axes".
 */
JALON_API JALON_CHECK jalon_status jalon_trajectory_create(
    const double* times_s, const double* positions_m, const double* attitudes_rad,
    const double* position_sigmas_m, const double* velocity_sigmas_m_s,
    const double* attitude_sigmas_rad, uint64_t count, const char* crs, const jalon_params* options,
    jalon_trajectory** out);
JALON_API jalon_trajectory* jalon_trajectory_retain(jalon_trajectory* trajectory);
JALON_API void jalon_trajectory_release(jalon_trajectory* trajectory);

/**
 * Reads a trajectory; operation "trajectory_file" or NULL.
 *
 * - Text: a line of names (time x y z roll pitch yaw, vx vy vz, and the sigmas sx sy sz, svx svy svz, sroll spitch
 *   syaw; "heading" is yaw; angles are radians, degrees where the name ends in _deg), then a line an epoch; blanks,
 *   tabs, commas or semicolons between. Positions are in the world already. Comments: "# axes ned", "# crs EPSG:2154".
 * - SBET (extension out or sbet): 17 doubles a record (136 bytes): time, latitude, longitude (rad), ellipsoidal height,
 *   3 velocities, roll, pitch, heading, wander angle (rad), 3 accelerations, 3 rates. Projected to UTM (WGS 84),
 *   Lambert-93 or east, north, up at an origin; axes "ned", headings against grid north: less the meridian convergence.
 *   The datum stays that of the file, heights those above the ellipsoid; of velocities, accelerations and rates nothing
 *   is taken. Lengths on a map are not lengths on the ground (0.4 mm a metre in UTM): what is measured from the vehicle
 *   keeps its own.
 * - sigma_path: NULL, or the file smrmsg that goes with SBET: 10 doubles a record (80 bytes): time, sigmas of north,
 *   east, down (m), of their velocities (m/s), of roll, pitch, heading (minutes of arc); linear between its records.
 *
 * JALON_ERROR_FORMAT names file, record or line, and field: times out of order, NaN, a sigma of 0, a record cut off.
 */
JALON_API JALON_CHECK jalon_status jalon_trajectory_read(const char* path, const char* sigma_path,
                                                         const jalon_params* options,
                                                         jalon_task* task, jalon_trajectory** out);
/**
 * Writes a trajectory as text or SBET, by the format or the extension, every digit kept. For SBET the options must say
 * where the positions are ("projection" with "utm_zone" or "origin"); velocities come from the positions where they are
 * not known, wander angle, accelerations and rates are 0. sigma_path: NULL, or where the file smrmsg goes.
 */
JALON_API JALON_CHECK jalon_status jalon_trajectory_write(const jalon_trajectory* trajectory,
                                                          const char* path, const char* sigma_path,
                                                          const jalon_params* options,
                                                          jalon_task* task);

/** Number of epochs. */
JALON_API JALON_CHECK jalon_status jalon_trajectory_count(const jalon_trajectory* trajectory,
                                                          uint64_t* out);
/** CRS text of the positions, "" when unknown. Lives as long as the trajectory. */
JALON_API JALON_CHECK jalon_status jalon_trajectory_crs(const jalon_trajectory* trajectory,
                                                        const char** out);
/** "enu" or "ned": what "axes" was. A static text. */
JALON_API JALON_CHECK jalon_status jalon_trajectory_axes(const jalon_trajectory* trajectory,
                                                         const char** out);
/**
 * One row an epoch; NaN where something is not known.
 *     column          type         unit  meaning
 *     time            float64      s     ascending
 *     xyz             float64 x 3  m     position
 *     attitude        float64 x 3  rad   roll, pitch, yaw
 *     velocity        float64 x 3  m/s   along x, y, z
 *     position_sigma  float64 x 3  m     standard deviations along x, y, z
 *     velocity_sigma  float64 x 3  m/s   along x, y, z
 *     attitude_sigma  float64 x 3  rad   of roll, pitch, yaw
 */
JALON_API JALON_CHECK jalon_status jalon_trajectory_epochs(const jalon_trajectory* trajectory,
                                                           jalon_fields** out);

/**
 * The trajectory at these ascending times: positions on the straight line between two epochs, attitudes on the
 * shortest arc (Shoemake 1985), velocities and sigmas linear. JALON_ERROR_INVALID_ARGUMENT naming the first time
 * outside. O(n + count).
 */
JALON_API JALON_CHECK jalon_status jalon_trajectory_interpolate(const jalon_trajectory* trajectory,
                                                                const double* times_s,
                                                                uint64_t count,
                                                                jalon_trajectory** out);
/**
 * The trajectory at control times: every spacing_s (1 s is usual) from its first epoch on, and at its last. The last
 * interval is between a half and one and a half of the spacing.
 */
JALON_API JALON_CHECK jalon_status jalon_trajectory_control(const jalon_trajectory* trajectory,
                                                            double spacing_s,
                                                            jalon_trajectory** out);
/**
 * What is known beforehand of the errors of x and of y: a first-order Gauss-Markov chain from the sigmas of position
 * and velocity, e' = n (e + dt v xi), normalised so that each epoch keeps its own sigma. The covariance of epochs i < j
 * is sigma_i^2 times the product of n from i to j - 1; its inverse, the information, is tridiagonal. Velocity sigmas
 * that are not known are taken as 0.01 m/s. JALON_ERROR_INVALID_ARGUMENT without position sigmas. O(n).
 *
 * One row an epoch, x and y; the last three columns of the step to the next epoch, NaN in the last row:
 *     column       type         unit  meaning
 *     time         float64      s     of the epoch
 *     sigma        float64 x 2  m     of its position
 *     information  float64 x 2  1/m2  on the diagonal
 *     beside       float64 x 2  1/m2  beside the diagonal
 *     factor       float64 x 2  1     n
 *     innovation   float64 x 2  m2    n^2 dt^2 v^2
 */
JALON_API JALON_CHECK jalon_status jalon_trajectory_prior(const jalon_trajectory* trajectory,
                                                          jalon_fields** out);
/** The trajectory with x and y moved by a draw of that chain each. Same seed, same bits. O(n). */
JALON_API JALON_CHECK jalon_status jalon_trajectory_perturb(const jalon_trajectory* trajectory,
                                                            uint64_t seed, jalon_trajectory** out);

JALON_END_C

#endif
