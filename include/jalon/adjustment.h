/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file adjustment.h
 * A mobile laser cloud and a building model, each wrong in its own way, brought into agreement: trajectory, blocks,
 * facades and strips are moved together, each by as much as its standard deviation lets it (Monnier 2014).
 *
 * Observations, expected 0, with their covariances: corrections of the trajectory's control positions in x and y
 * (jalon_trajectory_prior), translations of blocks, offsets of facades and of strips along the facade's normal n. One
 * condition for each strip that was seen: its plane passes through the weighted centroid of its points,
 *
 *     n . (Q + d_b - P(T)) + o_f + o_s = 0
 *
 * solved as Gauss-Helmert model without parameters (Mikhail 1976) by its sparse normal equations. What may move is
 * said by sigmas alone: a sure model locates the drive, a sure drive updates the model. Heights
 * stay unless the ground tells them, and attitudes unless they are said to have a constant error.
 *
 * An adjustment is immutable and may be read by many threads.
 */
#ifndef JALON_ADJUSTMENT_H
#define JALON_ADJUSTMENT_H

#include <jalon/cloud.h>
#include <jalon/model.h>
#include <jalon/trajectory.h>

JALON_BEGIN_C

typedef struct jalon_adjustment jalon_adjustment;

/** What became of a point: column "state" of the matches. */
enum {
  JALON_MATCH_ACCEPTED = 1,
  JALON_MATCH_NOTHING = 2, /**< its ray meets no strip, or a roof or the ground before one */
  JALON_MATCH_BEHIND = 3,  /**< its ray meets the strip from inside the building */
  JALON_MATCH_FAR = 4,     /**< farther from the strip than the sigmas allow */
  JALON_MATCH_TURNED = 5,  /**< the wall that the point is of stands otherwise than the strip */
  JALON_MATCH_UNSTEADY =
      6 /**< its match still changed in the sixth pass or later: it is left out from then on */
};

/**
 * Adjusts trajectory and model by a cloud of the drive.
 *
 * - trajectory: as given, with position sigmas; velocity sigmas that are not known are 0.01 m/s.
 * - cloud: with the field "time" (float64, s). "beam_origin" (float64 x 3) and "beam_direction" (float32 x 3), as
 *   jalon_trajectory_georeference gives them, make the rays; else they come from the trajectory and "lever_arm_m".
 *   "covariance" (float32 x 6) says how sure a point is, its pose included. Files keep such fields as
 *   "beam_origin_0", "beam_origin_1" ..., which do as well. Points outside of the trajectory's time take
 *   no part and are counted.
 * - model: of strips (jalon_model_building_strips); faces of no strip hide what is behind them ("occluders").
 * - options: operation "adjust".
 *
 * Steps, until no match changes, nothing moves by more than "tolerance_m", or after "most_passes"; the priors stay
 * those given:
 *
 * 1. One point a cube of "thin_m"; of these the ones that look like a vertical wall ("least_score"; Demantke et al.
 *    2011). Once.
 * 2. Each to the first strip that its own ray meets, both where they now stand; accepted when the strip faces the
 *    laser, the wall of the point is turned from it by at most "greatest_turn_rad", and the distance is below
 *    -log(0.05) = 2.996 ("bound", "refused_share") times the root of n^T C n + sigma_b^2 + sigma_f^2 + sigma_s^2.
 * 3. A condition for each strip with "least_points". With "kernel" = tukey points off the median of their strip count
 *    less, and strips that contradict the others by more than three of their sigmas; none is the centroid as printed.
 *    "sigma_point_m" is the noise of one point.
 * 4. The adjustment. "set_back" = behind keeps walls at their facades as given or behind them, as where eaves were
 *    digitised (least squares with bounds by an active set; Lawson & Hanson 1974; standard deviations are those
 *    without the bound, which are greater). "strip_correlation_m": offsets of a facade's strips hang together, by
 *    exp(-distance / length). "sigma_roll_bias_rad", "sigma_pitch_bias_rad" and "sigma_heading_bias_rad": the
 *    inertial unit sits turned in the vehicle, by one small turn b about the vehicle's own axes: sum_k t_k b_k joins
 *    the condition, t_k the mean of -n . ((R e_k) x (P - T)). Passes make them whole turns; a small turn
 *    and a small shift are told apart only by drives both ways, or by sigmas. "control_points": points seen at known
 *    times whose place is known hold the drive in plan, two conditions each; what a turn does to them is left out.
 *    With "sigma_ground_m" the drive's heights are adjusted as well, after the loop and apart: in each interval between
 *    control times by the median of the points under the vehicle (within 3.5 m of it in plan) below the model's faces
 *    of class "ground"; the ground's errors are a chain along the way ("ground_correlation_m").
 * 5. Where all has settled, with "exchange", "kernel" = tukey and "matches" = rays, explanations of the walls by the
 *    facades are compared as a whole (joint compatibility: Neira & Tardos 2001): a facade that is off by metres may
 *    have met the wall of a parallel neighbour, which no point is left for. What explains the points better by a clear
 *    margin (1000 times as likely) is taken and the passes go on, three times at most; where no margin is clear, or a
 *    facade would be off by more than step 2 accepts (five of its sigmas at most), those that claim one wall are not
 *    adjusted. Strips that may be off by metres, all else being surer, are looked for before step 2: where another
 *    may be that wall (less than 1000 times less likely), or it is farther off than step 2 accepts, they are not
 *    adjusted, nor are those that are so far off as one strip in twenty drives is.
 *
 * From the sixth pass on a point whose match still changes is left out, so that passes do not go to and fro
 * between two answers.
 *
 * Same bits whatever the threads. Not converged is a result that says so. O(points log strips) a pass, and linear in
 * strips and control times.
 *
 * JALON_ERROR_INVALID_ARGUMENT: no field "time" or one of another type, a time that is not finite, no point within
 * the trajectory's time, no position sigmas, sigma_strip_m = 0, a model without strips, CRS that differ, a control
 * point that is not whole or was seen outside of the trajectory's time, sigma_ground_m of a model without ground.
 * JALON_ERROR_INSUFFICIENT_DATA: no strip has enough points. With a sigma of blocks or facades of 0 the dense form is
 * taken, O(strips^3).
 */
JALON_API JALON_CHECK jalon_status jalon_trajectory_adjust(
    const jalon_trajectory* trajectory, const jalon_cloud* cloud, const jalon_model* model,
    const jalon_params* options, jalon_task* task, jalon_adjustment** out);
JALON_API jalon_adjustment* jalon_adjustment_retain(jalon_adjustment* adjustment);
JALON_API void jalon_adjustment_release(jalon_adjustment* adjustment);

/**
 * One row:
 *     column          type         unit  meaning
 *     converged       uint8        -     1: matches stay, or nothing moved any more
 *     passes          uint64       -     made
 *     points          uint64       -     whose rays were cast
 *     outside         uint64       -     points of the cloud outside of the trajectory's time
 *     matched         uint64       -     of the points, accepted
 *     strips          uint64       -     that were adjusted: the degrees of freedom of chi_square, with two a control
 *                                        point and one a facade that "set_back" holds
 *     rms             float64      m     of the accepted points off their strips, as weighted
 *     chi_square      float64      1     weighted square sum of all corrections
 *     p_value         float64      1     chance of as much or more where the sigmas are right: the test of the model.
 *                                        With "set_back" = behind an approximation, whose error was not measured.
 *                                        Small: sigmas too small, or wrong matches
 *     weak_direction  float64 x 2  1     level unit vector that the strips' normals hold least
 *     weak_share      float64      1     how much: of their squares along the direction held best
 *     weak_is_held    uint8        -     0: below 0.01, as along a straight street: nothing is known along it
 *     attitude_bias   float64 x 3  rad   turn b about the vehicle's axes x, y, z (roll, pitch, heading): its rotation
 *                                        is R Exp(b), not R; 0: not adjusted
 *     attitude_bias_sigma  float64 x 3  rad  standard deviations
 *     ground_points   uint64       -     under the vehicle, that told the heights
 *     ground_intervals  uint64     -     between control times, that have such points
 *     ground_chi_square  float64   1     weighted square sum of the heights' corrections, with as many degrees of
 *                                        freedom
 *     wrong_strips    float64      1     share of the matches that count which the cloud's field "strip" (uint32)
 *                                        contradicts; NaN without the field
 *     wrong_facades   float64      1     share of those to another facade
 *     doubtful_strips uint64       -     whose walls may be those of others: not adjusted
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_summary(const jalon_adjustment* adjustment,
                                                            jalon_fields** out);
/**
 * One row a pass:
 *     column      type     unit  meaning
 *     matched     uint64   -     accepted
 *     nothing     uint64   -     rays that met no strip
 *     behind      uint64   -     rays that met a strip from inside
 *     far         uint64   -     too far from the strip
 *     turned      uint64   -     of a wall that stands otherwise
 *     unsteady    uint64   -     left out because their match changed late
 *     strips      uint64   -     that were adjusted
 *     changed     uint64   -     points whose match is another than in the pass before
 *     rms         float64  m     of the accepted points before the step, as weighted
 *     step        float64  m     the greatest change of a control position, block, facade or strip
 *     chi_square  float64  1     after the step
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_iterations(const jalon_adjustment* adjustment,
                                                               jalon_fields** out);
/**
 * One row a control time:
 *     column       type         unit  meaning
 *     time         float64      s     ascending
 *     correction   float64 x 2  m     east and north, linear in between
 *     sigma        float64 x 2  m     standard deviations
 *     prior_sigma  float64 x 2  m     those before
 *     height_correction  float64  m   by the ground; 0 without
 *     height_sigma       float64  m   standard deviation
 *     height_prior_sigma  float64  m  that before
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_controls(const jalon_adjustment* adjustment,
                                                             jalon_fields** out);
/**
 * One row a block; what no strip holds keeps 0 and its prior sigma:
 *     column  type         unit  meaning
 *     offset  float64 x 2  m     east and north
 *     sigma   float64 x 2  m     standard deviations
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_blocks(const jalon_adjustment* adjustment,
                                                           jalon_fields** out);
/**
 * One row a facade:
 *     column  type     unit  meaning
 *     offset  float64  m     along its normal
 *     sigma   float64  m     standard deviation
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_facades(const jalon_adjustment* adjustment,
                                                            jalon_fields** out);
/**
 * One row a strip:
 *     column    type     unit  meaning
 *     offset    float64  m     along its facade's normal, beside those of facade and block
 *     sigma     float64  m     standard deviation
 *     points    uint64   -     that hold it; 0: it was not adjusted
 *     distance  float64  m     of the strip as given before its points as given; NaN: not adjusted
 *     doubtful  uint8    -     1: its wall may be another's: not adjusted
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_strips(const jalon_adjustment* adjustment,
                                                           jalon_fields** out);
/**
 * One row a point whose ray was cast, as the last pass matched it:
 *     column    type     unit  meaning
 *     point     uint32   -     of the cloud
 *     strip     uint32   -     that its ray meets, accepted or not; UINT32_MAX: none
 *     state     uint8    -     JALON_MATCH_...
 *     distance  float64  m     before the strip's plane, both where they stood then
 *     weight    float64  1     in the mean of its strip
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_matches(const jalon_adjustment* adjustment,
                                                            jalon_fields** out);
/**
 * The covariance of control positions and blocks, with the parameter "covariance" (else
 * JALON_ERROR_INVALID_ARGUMENT): a row and a component for each unknown, control positions east, then north, blocks
 * east, then north, the three turns of the vehicle where they are adjusted (rad for m), and with the parameter
 * "covariance_of" = "all" facades and the strips that were adjusted; at most 4096 (JALON_ERROR_LIMIT).
 *     column      type         unit  meaning
 *     group       uint8        -     0: control position, 1: block, 2: turn, 3: facade, 4: strip
 *     axis        uint8        -     0: east, 1: north; of turns 0: roll, 1: pitch, 2: heading; of facades and strips 0
 *     number      uint32       -     of the control position, block, facade or strip
 *     covariance  float64 x n  m2    with each unknown, in the order of the rows
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_covariance(const jalon_adjustment* adjustment,
                                                               jalon_fields** out);
/** The parameters it was made with, as JSON; lives as long as the adjustment. */
JALON_API JALON_CHECK jalon_status jalon_adjustment_parameters(const jalon_adjustment* adjustment,
                                                               const char** out);

/**
 * The adjusted trajectory: all epochs as they were given, corrected, with the standard deviations of their positions
 * that they have now. Attitudes are turned by "attitude_bias" and keep their standard deviations.
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_trajectory(const jalon_adjustment* adjustment,
                                                               jalon_trajectory** out);
/**
 * The adjusted model of strips; roofs go with their blocks.
 *
 * Written as CityJSON (jalon_model_write) its parts have attributes: a part those of the block, facade and strip above
 * it, a building those of its block; a strip is a WallSurface. The place that the model was given is the zero of all
 * offsets. They go with this model alone: what is made of it, or read from the file, has them no more; there its
 * blocks, facades and strips keep their numbers (jalon_model_building_strips).
 *     attribute                    unit  meaning
 *     block, facade, strip         -     numbers: rows of the tables above
 *     block_offset_east_m          m     east; block_offset_north_m: north
 *     block_prior_sigma_east_m     m     standard deviation before, and block_prior_sigma_north_m
 *     block_sigma_east_m           m     standard deviation after, and block_sigma_north_m
 *     block_matches                -     points that hold its strips
 *     facade_offset_m              m     along its normal
 *     facade_prior_sigma_m         m     standard deviation before
 *     facade_sigma_m               m     standard deviation after
 *     facade_matches               -     points that hold its strips
 *     strip_offset_m               m     along its facade's normal, beside those of facade and block
 *     strip_prior_sigma_m          m     standard deviation before
 *     strip_sigma_m                m     standard deviation after
 *     strip_matches                -     points that hold it; 0: it was not adjusted
 *     strip_distance_before_m      m     of the strip as given before its points as given; absent: not adjusted
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_model(const jalon_adjustment* adjustment,
                                                          jalon_model** out);
/**
 * A new cloud: one of the drive ("time", float64), with its points, "beam_origin" and "beam_direction" where the
 * adjusted trajectory puts them; beyond its ends they move as the ends do. In "covariance" and "point_sigma" the
 * variances of the trajectory's position are those it has now. O(n), parallel.
 */
JALON_API JALON_CHECK jalon_status jalon_adjustment_apply(const jalon_adjustment* adjustment,
                                                          const jalon_cloud* cloud,
                                                          jalon_task* task, jalon_cloud** out);

JALON_END_C

#endif
