/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file registrar.h
 * Registration: the pose that lays a moving cloud, or targets measured in it, onto a reference, and what that pose is
 * worth.
 *
 * A registrar holds parameters and no data; one thread at a time sets them, several may run it once set. A registration
 * is immutable and may be read by many threads. That a registration has not converged, stands on too little or is
 * ambiguous is a result that says so, not a failure; data from which nothing can be computed are one.
 */
#ifndef JALON_REGISTRAR_H
#define JALON_REGISTRAR_H

#include <jalon/cloud.h>
#include <jalon/comparer.h>

JALON_BEGIN_C

typedef struct jalon_registrar jalon_registrar;
typedef struct jalon_registration jalon_registration;

/** Why a registration stopped. */
enum {
  JALON_STOPPED_CONVERGED = 1,
  JALON_STOPPED_ITERATION_LIMIT = 2,
  JALON_STOPPED_TOO_FEW_PAIRS = 3, /**< what both have in common does not carry the pose */
  JALON_STOPPED_AMBIGUOUS = 4,     /**< a clearly different pose fits about as well */
  JALON_STOPPED_NOTHING_FOUND = 5  /**< no pose explains both */
};

/** Whether a pose may be used: column "verdict" of the summary. */
enum {
  JALON_VERDICT_NONE = 0,     /**< not judged: a start for fine registration (method "coarse") */
  JALON_VERDICT_ACCEPTED = 1, /**< both sides bear it out */
  JALON_VERDICT_DOUBTFUL = 2, /**< something speaks against it or leaves it open: see the reasons */
  JALON_VERDICT_REFUSED = 3   /**< it is wrong, or no pose was found */
};

/** What speaks for a pose that method "coarse" found. */
enum {
  JALON_POSE_FROM_FEATURES = 1, /**< local features that look alike and keep their distances */
  JALON_POSE_FROM_PLANES = 2,   /**< planes laid on each other */
  JALON_POSE_FROM_SLIDE = 3,    /**< the best pose, moved the way that least holds it */
  JALON_POSE_FROM_START = 4     /**< the start as given */
};

/** A point known in one frame: a measured target or a control point. Frozen. */
typedef struct jalon_target {
  const char* name; /**< UTF-8; NULL = unnamed */
  jalon_vec3 xyz;   /**< m; finite */
  double
      covariance[9]; /**< m2, row-major, symmetric; all 0 = the parameter "sigma_m" on each axis */
} jalon_target;

/**
 * method, NULL = "automatic":
 * - "automatic": "coarse", then "icp" from its pose, with the parameters of both: clouds that lie
 *   anywhere. The result is that of "icp", with the scores of "coarse" in the summary, from the
 *   first pose that is accepted. Where "coarse" is not sure of its best pose up to three are tried:
 *   two different ones that are accepted make it ambiguous; with none accepted it is that of
 *   "coarse". A start is one pose more to choose from.
 * - "icp": iterative closest points (Besl & McKay 1992; Chen & Medioni 1992) from a start that is
 *   about right: clouds of the same surfaces, half a metre and some degrees apart. Local planes of
 *   both clouds, steps on few points and then on all, a distance that shrinks down to three times
 *   the noise, robust weights. With the metric point to plane and a robust kernel the last steps
 *   are an adjustment of the pose together with patches of both clouds' surfaces, planes and
 *   paraboloids (Gruen & Akca 2005; Zhou, Koppel & Kaess 2021), where both clouds have such
 *   surfaces. Parameters: "metric", "kernel", "max_distance_m" ... (jalon_registrar_params). Of the
 *   pose it gives
 *   - the covariance: of the adjustment on patches, by the scatter of each cloud's points about
 *     them; without patches from the scatter of the local planes of both clouds, as it goes through
 *     pairs and planes into the pose, scaled by the residuals (a-posteriori sigma0). Assumed:
 *     independent noise of the points, surfaces that are the same in both. What neighbouring points
 *     have in common (a station's tilt, a warped mirror) is not in it, nor where neighbours of k
 *     points are wider than the surfaces are flat;
 *   - the directions that nothing fixes: those in which the pairs say no more than the noise of the
 *     planes' normals alone would, and along which the pose can be slid without the surfaces of both
 *     clouds agreeing less. No step is taken along them once they show; where the pose lies there
 *     hangs on the start and on the steps before, and the covariance is NaN.
 * - "targets": the rigid or similarity motion ("transform") from three or more targets known in
 *   both frames: closed form (Arun, Huang & Blostein 1987; Umeyama 1991), then the adjustment
 *   weighted with the covariances of both sides (Gauss-Helmert model; Pope 1972), and a test of
 *   each target for a blunder (data snooping; Baarda 1968).
 * - "coarse": a pose of two clouds without a guess, from planes and local features of both, some
 *   cells (summary "cell") good: a start for fine registration. It says when a clearly different
 *   pose fits about as well (JALON_STOPPED_AMBIGUOUS; the pose is the best one) and when none does
 *   (JALON_STOPPED_NOTHING_FOUND; the pose is the start). Both clouds are thinned to some 15 000
 *   cells: O(n) with a second or two for the search.
 *
 * That steps have converged says little: two different objects, a mirrored scan, another floor of
 * a building converge as well. So the pose of "icp" and "automatic" is judged (column "verdict"):
 * some thousand places of each surface are held against the other cloud. Of what the other scan
 * could see, by where it was taken from, the share is measured that lies on its surfaces, and the
 * share that its beams went through; things that differ together weigh, edges do not. Where a cloud
 * was taken from its stations say; of a cloud without stations it is found by the density of its
 * points, and without a place that could have seen them all the verdict rests on surfaces alone.
 * The pose is doubtful besides when the clouds want different scales (by 0.2 % and five sigmas),
 * when directions of it stay open, when little of one cloud lies on the other and when the steps
 * have not settled. "confidence" is the probability that the pose is right: a logistic regression
 * (Berkson 1944) on simulated pairs of five kinds of scenes, one right to two wrong, tried on
 * others; it is of the directions that are fixed. What has changed between two scans speaks against their pose as
 * another place would.
 * Unless a pose is accepted its covariance and all sigmas are NaN. The pose of targets is accepted when it is the
 * only one, fixed in all directions, and sigma0 agrees with the covariances given (else doubtful);
 * its sigmas stay.
 *
 * Method "icp": too little overlap is JALON_STOPPED_TOO_FEW_PAIRS: less than "min_overlap_percent"
 * of the moving points have a pair. About 3.5 s for 1 M points on 1 M with one thread.
 */
JALON_API JALON_CHECK jalon_status jalon_registrar_create(const char* method,
                                                          jalon_registrar** out);
/** The names of the methods, the default first. Static texts. */
JALON_API JALON_CHECK jalon_status jalon_registrar_methods(const char* const** names,
                                                           uint64_t* count);
/** A registrar of its own of the same method, with the same values. */
JALON_API JALON_CHECK jalon_status jalon_registrar_copy(const jalon_registrar* registrar,
                                                        jalon_registrar** out);
JALON_API jalon_registrar* jalon_registrar_retain(jalon_registrar* registrar);
JALON_API void jalon_registrar_release(jalon_registrar* registrar);
/** The registrar's own parameter set: setting it changes the registrar. The caller releases it. */
JALON_API JALON_CHECK jalon_status jalon_registrar_params(jalon_registrar* registrar,
                                                          jalon_params** out);
/**
 * Registers a cloud.
 *
 * - start: T_reference_moving to begin with, rigid within 1e-6; NULL = as they lie.
 *
 * JALON_ERROR_UNSUPPORTED for method "targets". JALON_ERROR_INSUFFICIENT_DATA for clouds too small
 * to register, JALON_ERROR_INVALID_ARGUMENT when both have a CRS and these differ.
 */
JALON_API JALON_CHECK jalon_status jalon_registrar_run(const jalon_registrar* registrar,
                                                       const jalon_cloud* reference,
                                                       const jalon_cloud* moving,
                                                       const jalon_transform* start,
                                                       jalon_task* task, jalon_registration** out);
/**
 * Registers targets by method "targets" (others: JALON_ERROR_UNSUPPORTED): those of the same name
 * in both sets are pairs. Where one side of a pair has no name it is found by distances: the
 * largest set of pairs whose targets are equally far from each other on both sides (a maximum
 * clique; for a similarity, in one proportion). When clearly different poses pair as many targets
 * within their covariances, as for the corners of a square, the registration is
 * JALON_STOPPED_AMBIGUOUS, and the best of them is given. Targets left over are counted. O(count)
 * for named targets; with "remove_outliers" times those removed.
 *
 * Georeferencing is this with control points as the reference: the work is done relative to whole
 * metres near the targets, so that coordinates of seven digits lose nothing, and the pose is the
 * one of the coordinates given. Rounding of the largest coordinate, about 1 nm, is all that is
 * lost.
 *
 * The covariance follows from those of the targets ("sigma0" = known), or is scaled by the
 * residuals (estimated): then its 95 % ellipsoid is the one of 6 F(6, redundancy). Over 1000
 * registrations it covers the truth in 93 to 97 %.
 *
 * - JALON_ERROR_INSUFFICIENT_DATA for fewer than three pairs, or no three of the same distances.
 * - JALON_ERROR_LIMIT for more than 10 000 pairs of unnamed targets to choose from (similarity: 1
 *   600).
 * - JALON_ERROR_DEGENERATE for pairs along one line, as far as their covariances can tell (a turn
 *   with a standard deviation above 0.1 rad), and for sets of which one is the mirror image of the
 *   other.
 * - JALON_ERROR_INVALID_ARGUMENT for two targets of one name or within 0.1 mm of each other in one
 *   set, coordinates that are not finite, a covariance with a negative variance.
 */
JALON_API JALON_CHECK jalon_status jalon_registrar_run_targets(
    const jalon_registrar* registrar, const jalon_target* reference, uint64_t reference_count,
    const jalon_target* moving, uint64_t moving_count, jalon_task* task, jalon_registration** out);

JALON_API jalon_registration* jalon_registration_retain(jalon_registration* registration);
JALON_API void jalon_registration_release(jalon_registration* registration);
/** T_reference_moving; of a similarity with the scale in its matrix. */
JALON_API JALON_CHECK jalon_status jalon_registration_pose(const jalon_registration* registration,
                                                           jalon_transform* T_reference_moving);
/**
 * One row. Every method:
 *     column        type          unit  meaning
 *     converged     uint8         -     1: the pose stands; 0: see "stopped"
 *     stopped       uint8         -     JALON_STOPPED_...
 *     iterations    uint64        -     steps made
 *     pairs         uint64        -     that the last step stood on
 *     rms           float64       m     of the residuals of the pairs
 *     scale         float64       1     of the pose
 *     unobservable  uint64        -     directions of the six that nothing fixes
 *     centre        float64 x 3   m     that the rotations of the covariance turn about
 *     covariance    float64 x 36  -     row-major: of the rotation vector (rad) about the centre,
 *                                       then of the shift (m) of the centre, in the reference
 *                                       frame; NaN where it is not known
 *     extent        float64       m     radius of gyration of what carries the pose
 *     verdict       uint8         -     JALON_VERDICT_...
 *     confidence    float64       1     probability that the pose is right; NaN where not measured
 *
 * Method "icp"; sigma0, patches and redundancy only after steps on all points with enough pairs:
 *     column         type     unit  meaning
 *     kept           float64  1     share of the moving points that have a pair
 *     sigma          float64  m     of the residuals, robust
 *     sigma0         float64  1     a posteriori: residuals over what the planes' scatter foretells
 *     patches        uint64   -     of both clouds that the pose settled on; 0 = it rests on pairs
 *     redundancy     float64  -     pairs less unknowns
 *     thinning_cell  float64  m     edge of the cubes thinned to a point, of the least where points lie in lines;
 *                                   0 = all points were used
 * and of the verdict; NaN where not measured:
 *     column                  type     unit  meaning
 *     near_moving             float64  1     of the moving surface, share within reach (four
 *                                            spacings) of the reference
 *     near_reference          float64  1     of the reference's surface, of the moving cloud
 *     explained_moving        float64  1     of the moving surface that the other scan could see,
 *                                            share on its surfaces
 *     explained_reference     float64  1     the same of the reference's
 *     pierced_moving          float64  1     ... share that the other's beams went through; NaN
 *                                            without stations
 *     pierced_reference       float64  1     the same of the reference's
 *     contradicted_moving     float64  1     ... share that differs together with what is about it
 *     contradicted_reference  float64  1     the same of the reference's
 *     wanted_scale            float64  1     of the moving cloud, were it free
 *     wanted_scale_sigma      float64  1     its standard deviation
 *
 * Method "targets":
 *     column              type     unit  meaning
 *     removed             uint64   -     outliers that were taken away
 *     unpaired_reference  uint64   -     reference targets without a partner
 *     unpaired_moving     uint64   -     moving targets without a partner
 *     redundancy          uint64   -     observations more than unknowns
 *     sigma0              float64  1     of unit weight from the residuals, 1 where they agree with
 *                                        the covariances; NaN without redundancy
 *     sigma0_estimated    uint8    -     1: the covariance is scaled by it
 *     global_p_value      float64  1     of sigma0 = 1, two-sided
 *     global_accepted     uint8    -     1: not below "significance"
 *     scale_sigma         float64  1     of the scale; 0 for a rigid motion
 *     solutions           uint64   -     clearly different poses that pair the targets as well; 1 =
 *                                        unique
 *
 * Method "coarse", whose sigmas and covariance are NaN; all but "cell" and "candidates" also after
 * an "icp" that method "automatic" made:
 *     column             type     unit  meaning
 *     score              float64  1     overlap of both clouds times likeness, 0 ... 1
 *     overlap_moving     float64  1     share of the moving surface that lies on the reference;
 *                                       directions that surfaces face weigh alike
 *     overlap_reference  float64  1     share of the reference's surface on the moving one
 *     likeness           float64  1     share of the salient places near the other cloud that look
 *                                       alike there
 *     ambiguous          uint8    -     1: a clearly different pose fits about as well
 *     second_score       float64  1     of the best pose that is clearly different; 0 = none
 *     cell               float64  m     edge of the cells that both were thinned to
 *     candidates         uint64   -     poses looked at
 */
JALON_API JALON_CHECK jalon_status
jalon_registration_summary(const jalon_registration* registration, jalon_fields** out);
/**
 * The log of the iterations, one row each. Method "icp"; steps on patches are a level of their own:
 *     column      type     unit  meaning
 *     level       int32    -     0 = the fewest points
 *     pairs       uint64   -     with a weight, both ways; on patches points of both clouds
 *     kept        float64  1     share of the level's moving points that have a pair
 *     rms         float64  m     weighted residuals before the step
 *     sigma       float64  m     1.4826 x median absolute residual
 *     distance    float64  m     the greatest residual of a pair
 *     turn        float64  rad   of the step
 *     shift       float64  m     of the step, at the centre
 *     observable  uint8    -     directions that the pairs fixed
 *
 * Method "targets", the steps of the adjustment:
 *     column            type     unit  meaning
 *     weighted_squares  float64  1     sum of the weighted squared residuals before the step
 *     step              float64  1     its length in standard deviations of the pose
 *
 * Method "coarse", the poses that are clearly different from each other, the best first:
 *     column             type          unit  meaning
 *     score              float64       1     as in the summary, like the next three
 *     overlap_moving     float64       1     share of the moving surface on the reference
 *     overlap_reference  float64       1     share of the reference's surface on the moving one
 *     likeness           float64       1     share of the salient places near the other cloud that
 *                                            look alike there
 *     salient            float64       1     share of the salient places that come near the other
 *                                            cloud
 *     rms                float64       m     of what lies on the other surface, off its planes
 *     source             uint8         -     JALON_POSE_FROM_...
 *     pose               float64 x 12  -     T_reference_moving, rows of [A | t]
 */
JALON_API JALON_CHECK jalon_status
jalon_registration_iterations(const jalon_registration* registration, jalon_fields** out);
/**
 * One row a pair. Method "targets", the pairs in use first, then those removed as outliers, judged
 * by the others; in the reference frame:
 *     column      type         unit  meaning
 *     reference   uint64       -     index into the reference set
 *     moving      uint64       -     index into the moving set
 *     residual    float64 x 3  m     moved minus reference
 *     sigma       float64 x 3  m     its standard deviation
 *     redundancy  float64 x 3  1     0 no other target controls it, 1 all do; they sum up to the
 *                                    redundancy
 *     normalised  float64 x 3  1     Baarda's w
 *     detectable  float64 x 3  m     the error along an axis that the test finds with the chance
 *                                    "power"; infinity where nothing controls it
 *     p_value     float64      1     of the test of the whole target, in as many dimensions as are
 *                                    controlled: chi-square, or with an estimated sigma0 Pope's tau
 *                                    and its like
 *     outlier     uint8        -     1: p_value below "significance"
 *     removed     uint8        -     1: it took no part in the pose
 *
 * Method "icp", the moving points with a partner; no rows when the steps ended on few points:
 *     column     type     unit  meaning
 *     moving     uint32   -     index of the point
 *     reference  uint32   -     index of its partner
 *     residual   float32  m     of the moved point over its partner's plane
 *     weight     float32  1     of the kernel
 */
JALON_API JALON_CHECK jalon_status
jalon_registration_residuals(const jalon_registration* registration, jalon_fields** out);
/**
 * The name of the pair in row i of the residuals, the targets'; "" where it has none. Lives as long as it.
 * JALON_ERROR_INVALID_ARGUMENT beyond the rows.
 */
JALON_API JALON_CHECK jalon_status
jalon_registration_pair_name(const jalon_registration* registration, uint64_t i, const char** out);
/**
 * The six principal directions of the pose, the weakest first.
 *     column      type         unit  meaning
 *     direction   float64 x 6  -     turn about the centre (rad), shift (m); a step of 1 m by the
 *                                    extent
 *     sigma       float64      m     standard deviation along it
 *     observable  uint8        -     0 = the data do not fix it; where the pose lies there means nothing
 */
JALON_API JALON_CHECK jalon_status
jalon_registration_directions(const jalon_registration* registration, jalon_fields** out);
/**
 * Why the pose is not accepted: sentences in English, a line each; "" when it is, or is not judged. Lives as long as
 * the registration.
 */
JALON_API JALON_CHECK jalon_status
jalon_registration_reasons(const jalon_registration* registration, const char** out);
/** The parameters it was made with, as JSON; lives as long as the registration. */
JALON_API JALON_CHECK jalon_status
jalon_registration_parameters(const jalon_registration* registration, const char** out);
/** A new cloud: the cloud moved by the pose, as jalon_cloud_transform; one without a CRS gets the reference's. */
JALON_API JALON_CHECK jalon_status jalon_registration_apply(const jalon_registration* registration,
                                                            const jalon_cloud* cloud,
                                                            jalon_task* task, jalon_cloud** out);
/**
 * What the alignment of the clouds is worth flows into the level of detection: sets "registration_covariance" and
 * "registration_centre" of a comparer of method "m3c2" (others: JALON_ERROR_UNSUPPORTED). In directions that nothing
 * fixes there is no covariance: JALON_ERROR_DEGENERATE, and the parameters stay.
 */
JALON_API JALON_CHECK jalon_status
jalon_comparer_use_registration(jalon_comparer* comparer, const jalon_registration* registration);

JALON_END_C

#endif
