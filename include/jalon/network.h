/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file network.h
 * A total-station network adjusted in three dimensions by least squares: stations and coded points with their
 * covariances, every observation tested (Baarda 1968). What comes out goes straight into the methods by feature codes
 * of segmenter.h.
 *
 * Axes: x east, y north, z up, in a map; directions count clockwise. A sight from the instrument I to the target T,
 * with d = T - I, s its level length and o the orientation of the circle, is
 *
 *     direction  atan2(dx, dy) - o
 *     zenith     atan2(s, dz - (1 - k) s^2 / 2R)     k refraction, R radius of the Earth
 *     distance   hypot(s / scale, dz)
 *
 * An instrument stands off its point by an unknown that is observed as 0, once a setup ("sigma_centring_m",
 * "sigma_height_m"); a target off its own once for each setup that sights it, which correlates the observations of it
 * ("sigma_target_centring_m", "sigma_target_height_m").
 *
 * A network is immutable and may be read by many threads.
 */
#ifndef JALON_NETWORK_H
#define JALON_NETWORK_H

#include <jalon/fields.h>
#include <jalon/params.h>
#include <jalon/task.h>

JALON_BEGIN_C

typedef struct jalon_network jalon_network;

/** What an observation is of: column "kind". */
enum {
  JALON_OBSERVATION_DIRECTION = 1, /**< rad */
  JALON_OBSERVATION_ZENITH = 2,    /**< rad */
  JALON_OBSERVATION_DISTANCE = 3,  /**< m, along the slope */
  JALON_OBSERVATION_X = 4,         /**< of a weak point; Y, Z: so too */
  JALON_OBSERVATION_Y = 5,
  JALON_OBSERVATION_Z = 6,
  JALON_OBSERVATION_CENTRING = 7, /**< of an instrument, in x, then in y: expected 0 */
  JALON_OBSERVATION_HEIGHT = 8    /**< error of an instrument's height: expected 0 */
};

/**
 * Adjusts a network from two texts, UTF-8. Of both the first line names the columns, in any order; cells are parted by
 * semicolons, tabs, commas or blanks, whichever the first line has; "-" or nothing is what is not known. Blank lines
 * and those that begin with # are passed over.
 *
 * - observations: columns from, to; any of direction, zenith (in "angle_unit"), distance (m); and instrument_height,
 *   target_height (m, else 0), setup, sigma_direction, sigma_zenith, sigma_distance, code. Another "from" or "setup"
 *   than in the line before is a new setup, with an orientation of its own. A zenith angle beyond half a circle is of
 *   the second face.
 * - points: NULL, or columns id, x, y, z (m), sx, sy, sz (m), code. A standard deviation of 0 fixes a coordinate, one
 *   above 0 makes it weak (observed), none leaves it to be determined; coordinates without one are approximate. Points
 *   that are only sighted need no line: their sights place them.
 * - options: operation "network". "datum" = free takes no point as fixed or weak: the network's shape alone, by
 *   inner constraints on all points (Meissl 1969), for at most 6000 unknowns. "reject" leaves the worst outlier out and
 *   adjusts again until there is none.
 *
 * Gauss-Newton on sparse normal equations; O(observations) a step and O(unknowns) for the covariance of each point, as
 * the network is sparse. Not converged is a result that says so. Same bits whatever the threads.
 *
 * JALON_ERROR_FORMAT names list, line and cell. JALON_ERROR_INSUFFICIENT_DATA: no observation, a point that nothing
 * places, nothing to spare with sigma0 = estimated. JALON_ERROR_DEGENERATE names a point that nothing holds.
 * JALON_ERROR_UNSUPPORTED: too large a free network.
 */
JALON_API JALON_CHECK jalon_status jalon_network_adjust(const char* observations,
                                                        const char* points,
                                                        const jalon_params* options,
                                                        jalon_task* task, jalon_network** out);
JALON_API jalon_network* jalon_network_retain(jalon_network* network);
JALON_API void jalon_network_release(jalon_network* network);

/**
 * One row:
 *     column            type     unit  meaning
 *     converged         uint8    -     1: the coordinates stay
 *     iterations        uint64   -     steps
 *     last_step         float64  m     greatest change of a coordinate in the last step
 *     points            uint64   -
 *     setups            uint64   -     of the instrument
 *     observations      uint64   -     centrings included
 *     unknowns          uint64   -     coordinates, orientations, centrings
 *     defect            uint64   -     inner constraints of a free network, else 0
 *     redundancy        int64    -     observations to spare
 *     rejected          uint64   -     outliers left out
 *     outliers          uint64   -     that the tests call so, rejected ones included
 *     weighted_squares  float64  1     v^T P v
 *     sigma0            float64  1     factor of the standard deviations: 1, or estimated
 *     p_value           float64  1     of v^T P v, both sides, were the sigmas right: the global test
 */
JALON_API JALON_CHECK jalon_status jalon_network_summary(const jalon_network* network,
                                                         jalon_fields** out);
/**
 * One row a point, those of the list first:
 *     column           type         unit  meaning
 *     xyz              float64 x 3  m     adjusted
 *     sigma            float64 x 3  m     standard deviations; 0: fixed
 *     covariance       float64 x 9  m2    row-major
 *     ellipse_major    float64      m     semi-axes of the standard ellipse in the map; times 2.448 it holds 95 %
 *     ellipse_minor    float64      m
 *     ellipse_azimuth  float64      rad   of the longer one, clockwise from north
 */
JALON_API JALON_CHECK jalon_status jalon_network_points(const jalon_network* network,
                                                        jalon_fields** out);
/**
 * One row an observation; angles in rad, all others in m:
 *     column      type     unit  meaning
 *     kind        uint8    -     JALON_OBSERVATION_...
 *     line        uint64   -     of the list of observations, or of points; 0: of none
 *     from        uint64   -     point
 *     to          uint64   -     point
 *     measured    float64  -     in the first face
 *     residual    float64  -     adjusted less measured
 *     sigma       float64  -     of what was measured, the target's centring included
 *     redundancy  float64  1     share of an error that shows in the residual
 *     normalised  float64  1     residual over its standard deviation: Baarda's w; 0 where nothing controls it
 *     p_value     float64  1     chance of as much by noise alone
 *     detectable  float64  -     least error that the test finds with "power"; infinity: none
 *     outlier     uint8    -     1: p_value below "significance"
 *     rejected    uint8    -     1: left out; residual and test are of what the others foretell
 */
JALON_API JALON_CHECK jalon_status jalon_network_observations(const jalon_network* network,
                                                              jalon_fields** out);
/** The id of a point; lives as long as the network. JALON_ERROR_INVALID_ARGUMENT: no such point. */
JALON_API JALON_CHECK jalon_status jalon_network_point_name(const jalon_network* network,
                                                            uint64_t i, const char** out);
/**
 * The adjusted points with a code, a line "ID;X;Y;Z;code" each: what the parameter "codes" of segmenter methods
 * "survey_codes" and "target_codes" takes. Lives as long as the network.
 */
JALON_API JALON_CHECK jalon_status jalon_network_codes(const jalon_network* network,
                                                       const char** out);
/** The parameters it was adjusted with, as JSON; lives as long as the network. */
JALON_API JALON_CHECK jalon_status jalon_network_parameters(const jalon_network* network,
                                                            const char** out);

JALON_END_C

#endif
