/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file evaluate.h
 * Evaluation: how a result agrees with a reference that is known to be right (hand labels, the virtual scanner's truth,
 * another program).
 *
 * An evaluation is immutable and may be read by many threads; it keeps neither of its inputs. Tables are snapshots that
 * the caller releases. Rates lie in 0 ... 1; a rate or mean of nothing is NaN.
 */
#ifndef JALON_EVALUATE_H
#define JALON_EVALUATE_H

#include <jalon/model.h>
#include <jalon/segmenter.h>

JALON_BEGIN_C

typedef struct jalon_evaluation jalon_evaluation;

/**
 * A segmentation from a field of whole numbers: a hand-labelled reference, the scanner's "face", what
 * jalon_segmentation_cloud wrote into a file, the result of other software. Each value but the noise labels (0 by
 * default; NaN always) is a segment; values may be any whole numbers. Rows come by falling number of points, ties by
 * value; column "source_label" of jalon_segmentation_segments keeps the value. Planes are least-squares planes of all
 * points of a segment; a segment whose points give none (fewer than 3, equal, collinear) keeps its row with NaN in it
 * and orientation JALON_ORIENTATION_NONE. Operation "labels". JALON_ERROR_NOT_FOUND for an unknown field,
 * JALON_ERROR_INVALID_ARGUMENT for one that holds fractions or several components a point. An empty cloud gives a
 * segmentation without segments. O(n log n), parallel.
 */
JALON_API JALON_CHECK jalon_status jalon_segmentation_from_labels(const jalon_cloud* cloud,
                                                                  const char* label_field,
                                                                  const jalon_params* options,
                                                                  jalon_task* task,
                                                                  jalon_segmentation** out);

/**
 * Compares two segmentations of one cloud: the same points in the same order, up to coordinate_tolerance_m; otherwise
 * JALON_ERROR_INVALID_ARGUMENT. Operation "evaluation".
 *
 * Segments below min_points or min_area_m2 are left out on both sides. Of the others those pairs (A, SR) are chosen,
 * one to one, whose overlaps have the largest sum (optimal assignment, Kuhn 1955), pairs below min_iou excluded. A is a
 * part of SR when part_share of A's points lie in SR, and the other way round. Reference segments with two or more
 * parts are over-segmented, automatic ones with two or more under-segmented; a reference of whose points less than
 * covered_share lie in any automatic segment is non-segmented (terms of Pu & Vosselman 2006). Rates and geometry:
 * Boulaassal 2010, 5.5.3.2 (eq. 5.9-5.11). Empty segmentations are no error. O(n log n + sparse assignment), parallel.
 */
JALON_API JALON_CHECK jalon_status jalon_segmentation_evaluate(const jalon_segmentation* automatic,
                                                               const jalon_segmentation* reference,
                                                               const jalon_params* options,
                                                               jalon_task* task,
                                                               jalon_evaluation** out);
JALON_API jalon_evaluation* jalon_evaluation_retain(jalon_evaluation* evaluation);
JALON_API void jalon_evaluation_release(jalon_evaluation* evaluation);
/**
 * One row a pair of an automatic segment A and a reference segment SR, ascending by reference
 * label. The last three are NaN where a side has no plane.
 *     column             type     unit    meaning
 *     automatic          uint32   -       label of A
 *     reference          uint32   -       label of SR
 *     card_automatic     uint64   points  Card A
 *     card_reference     uint64   points  Card SR
 *     intersection       uint64   points  I, points of both
 *     commission         uint64   points  D+ = A \ SR
 *     omission           uint64   points  D- = SR \ A
 *     tdr                float64  1       I / Card SR
 *     tda                float64  1       I / Card A
 *     iou                float64  1       intersection over union
 *     angle              float64  rad     between the normals, 0 ... pi/2
 *     distance           float64  m       mean distance of A's points from SR's plane
 *     offset_difference  float64  m       signed: A's centroid beyond SR's plane
 */
JALON_API JALON_CHECK jalon_status jalon_evaluation_pairs(const jalon_evaluation* evaluation,
                                                          jalon_fields** out);
/**
 * One row an automatic segment, in the order of its labels.
 *     column        type    unit    meaning
 *     label         uint32  -       of the segment
 *     source_label  int64   -       its value in the field it was made from
 *     points        uint64  points  of the segment
 *     kept          uint8   -       1; 0 = left out, too small
 *     partner       uint32  -       the other side's label of its pair; 0 = unmatched
 *     parts         uint32  -       segments of the other side that are parts of it
 *     covered       uint64  points  its points that segments of the other side hold
 */
JALON_API JALON_CHECK jalon_status jalon_evaluation_automatic(const jalon_evaluation* evaluation,
                                                              jalon_fields** out);
/** The same columns of the reference segments. */
JALON_API JALON_CHECK jalon_status jalon_evaluation_reference(const jalon_evaluation* evaluation,
                                                              jalon_fields** out);
/**
 * One row.
 *     column                  type     unit    meaning
 *     pairs                   uint64   -       segments matched one to one
 *     unmatched_automatic     uint64   -       kept automatic segments without a pair
 *     unmatched_reference     uint64   -       kept reference segments without a pair
 *     left_out_automatic      uint64   -       automatic segments below the smallest size
 *     left_out_reference      uint64   -       reference segments below the smallest size
 *     over_segmented          uint64   -       reference segments with two or more parts
 *     under_segmented         uint64   -       automatic segments with two or more parts
 *     non_segmented           uint64   -       reference segments mostly in no automatic one
 *     card_automatic          uint64   points  sums over the pairs, this and the next four
 *     card_reference          uint64   points  Card SR
 *     intersection            uint64   points  I
 *     commission              uint64   points  D+
 *     omission                uint64   points  D-
 *     global_tdr              float64  1       of these sums, as the next two
 *     global_tda              float64  1       I / Card A
 *     global_iou              float64  1       intersection over union
 *     mean_tdr                float64  1       over the pairs, as the next two
 *     mean_tda                float64  1       I / Card A
 *     mean_iou                float64  1       intersection over union
 *     detection               float64  1       mean TDR over all kept reference segments, unmatched
 *                                              ones as 0
 *     accuracy                float64  1       mean TDA over all kept automatic segments, unmatched
 *                                              ones as 0
 *     mean_angle              float64  rad     over the pairs, as the next five
 *     std_angle               float64  rad     divided by n - 1
 *     mean_distance           float64  m       of A's points from SR's plane
 *     std_distance            float64  m       divided by n - 1
 *     mean_offset_difference  float64  m       A's centroid beyond SR's plane
 *     std_offset_difference   float64  m       divided by n - 1
 */
JALON_API JALON_CHECK jalon_status jalon_evaluation_totals(const jalon_evaluation* evaluation,
                                                           jalon_fields** out);

/**
 * Confusion of two class fields (whole numbers, any element type) of one cloud. O(n log n),
 * parallel.
 *
 * - Points without a class (NaN), and those whose reference class is among "ignored_classes", are
 *   left out.
 * - options: operation "confusion".
 * - classes, totals: each may be NULL.
 *
 * JALON_ERROR_LIMIT for more than 1024 different classes.
 *
 * classes, one row a class that occurs in either field, ascending:
 *     column     type        unit    meaning
 *     class      int64       -       value of the class fields
 *     reference  uint64      points  of the class in the reference
 *     predicted  uint64      points  given the class
 *     correct    uint64      points  both
 *     precision  float64     1       correct / predicted
 *     recall     float64     1       correct / reference
 *     f1         float64     1       harmonic mean of both
 *     iou        float64     1       intersection over union
 *     confusion  uint64 x n  points  of the row's reference class given each of the n classes, in
 *                                    the order of the rows
 *
 * totals, one row:
 *     column          type     unit    meaning
 *     points          uint64   points  compared
 *     correct         uint64   points  of equal class
 *     accuracy        float64  1       correct / points
 *     mean_precision  float64  1       over the classes the reference has, as the next two
 *     mean_recall     float64  1       correct / reference
 *     mean_f1         float64  1       harmonic mean of both
 *     kappa           float64  1       agreement beyond chance (Cohen 1960)
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_confusion(
    const jalon_cloud* cloud, const char* class_field, const char* reference_field,
    const jalon_params* options, jalon_task* task, jalon_fields** classes, jalon_fields** totals);

/* ---- models (Boulaassal 2010, 5.6) ---- */

typedef struct jalon_model_evaluation jalon_model_evaluation;

/**
 * Compares a model with a reference: a survey, a drawing, the model that was scanned. Operation "model_evaluation".
 *
 * Faces with their openings taken off (or, "compare" = openings, the openings alone) are put into the plane of their
 * reference, arcs as chords of 0.1 mm error, coordinates on a grid of 0.1 mm. Those pairs are chosen, one to one, whose
 * shared areas have the largest sum (optimal assignment, Kuhn 1955), among pairs whose planes agree within
 * "angle_tolerance_rad" and "distance_tolerance_m" and whose intersection over union reaches "min_iou". With "group" =
 * plane all faces of a plane are one polygon; so are the coplanar triangles of a model without faces, and then both
 * models go by plane.
 *
 * Of each pair: the five area indices (5.6.3.2, table 5.5; definitions by "formulas"), the two borders' distances both
 * ways (precision, recall and F1 at "contour_tolerance_m", Hausdorff distance and its 95 % form) and the planes' angle
 * and distance. Corners of paired faces (turns of "corner_angle_rad", ends of arcs) are paired, the nearest first, up
 * to "vertex_tolerance_m" (table 5.8). "mode" =
 * relative moves the model by the medians of its vertices' deviations first and compares again. Classes of parts choose
 * what counts: "classes", "ignored_classes". Empty models are no error. O(pairs of near faces x corners), parallel.
 */
JALON_API JALON_CHECK jalon_status jalon_model_evaluate(const jalon_model* model,
                                                        const jalon_model* reference,
                                                        const jalon_params* options,
                                                        jalon_task* task,
                                                        jalon_model_evaluation** out);
JALON_API jalon_model_evaluation* jalon_model_evaluation_retain(jalon_model_evaluation* evaluation);
JALON_API void jalon_model_evaluation_release(jalon_model_evaluation* evaluation);
/**
 * One row a pair of an automatic face SA and a reference face SR, ascending by reference. Areas are
 * in the reference's plane; where nothing is shared the factors are inf. With "formulas" = thesis
 * branching and miss are swapped.
 *     column             type     unit  meaning
 *     automatic          uint32   -     row of jalon_model_evaluation_automatic
 *     reference          uint32   -     row of jalon_model_evaluation_reference
 *     area_automatic     float64  m2    |SA|
 *     area_reference     float64  m2    |SR|
 *     intersection       float64  m2    TP, area of both
 *     excess             float64  m2    FP = |SA \ SR|
 *     deficit            float64  m2    FN = |SR \ SA|
 *     completeness       float64  1     TP / |SR|
 *     correctness        float64  1     TP / |SA|
 *     quality            float64  1     TP / |SR u SA|
 *     branching          float64  1     FP / TP
 *     miss               float64  1     FN / TP
 *     failure            float64  1     FP / |SR|
 *     omission           float64  1     FN / |SR|
 *     angle              float64  rad   between the planes, 0 ... pi/2
 *     distance           float64  m     of the automatic face's middle beyond the reference's plane
 *     same_class         uint8    -     1: their parts have one class
 *     contour_precision  float64  1     share of the automatic border within the tolerance of the
 *                                       reference
 *     contour_recall     float64  1     the other way
 *     contour_f1         float64  1     harmonic mean of both
 *     contour_mean       float64  m     distance of the automatic border from the reference
 *     contour_rms        float64  m     of the same
 *     contour_mean_back  float64  m     distance of the reference border from the automatic one
 *     contour_rms_back   float64  m     of the same
 *     hausdorff95        float64  m     95 % of both borders are nearer
 *     hausdorff          float64  m     largest distance
 */
JALON_API JALON_CHECK jalon_status
jalon_model_evaluation_pairs(const jalon_model_evaluation* evaluation, jalon_fields** out);
/**
 * One row a face (or opening, or plane) of the automatic model. Faces of classes that do not count
 * and those without an area are not listed.
 *     column   type     unit  meaning
 *     face     uint32   -     row of jalon_model_faces, of the largest of several; of a mesh a
 *                             triangle
 *     ring     uint32   -     of an opening: row of jalon_model_rings; else UINT32_MAX
 *     part     uint32   -     part of the model
 *     merged   uint32   -     how many faces it stands for
 *     area     float64  m2    openings taken off
 *     kept     uint8    -     1; 0 = left out, too small
 *     partner  uint32   -     row of the other side's table; UINT32_MAX = unmatched
 */
JALON_API JALON_CHECK jalon_status
jalon_model_evaluation_automatic(const jalon_model_evaluation* evaluation, jalon_fields** out);
/** The same columns of the reference. */
JALON_API JALON_CHECK jalon_status
jalon_model_evaluation_reference(const jalon_model_evaluation* evaluation, jalon_fields** out);
/**
 * One row a pair of homologous vertices, ascending by place of the reference. Deviations are
 * automatic less reference, after the shift of "mode" = relative.
 *     column      type     unit  meaning
 *     automatic   uint32   -     row of jalon_model_vertices
 *     reference   uint32   -     row of jalon_model_vertices
 *     dx          float64  m     deviation along x
 *     dy          float64  m     along y
 *     dz          float64  m     along z
 *     distance    float64  m     its length
 *     along       float64  m     along the reference's largest face there
 *     up          float64  m     up that face
 *     out         float64  m     along its normal
 *     normalised  float64  1     against the covariances of the two vertices, sqrt(e^T C^-1 e):
 *                                below 2.80 in 95 % of the cases where these are right; NaN where
 *                                neither has one
 */
JALON_API JALON_CHECK jalon_status
jalon_model_evaluation_vertices(const jalon_model_evaluation* evaluation, jalon_fields** out);
/**
 * One row; * stands for the columns of that name in the tables above.
 *     column                  type         unit  meaning
 *     pairs                   uint64       -     faces matched one to one
 *     unmatched_automatic     uint64       -     kept automatic faces without a pair
 *     unmatched_reference     uint64       -     kept reference faces without a pair
 *     left_out_automatic      uint64       -     automatic faces below the smallest size
 *     left_out_reference      uint64       -     reference faces below the smallest size
 *     same_class              uint64       -     pairs whose parts have one class
 *     area_automatic          float64      m2    sum over all kept faces, unmatched ones included
 *     area_reference          float64      m2    the same
 *     intersection            float64      m2    the same
 *     total_*                 float64      1     area indices of these sums: weighted by area
 *     mean_*                  float64      1     area indices, over the pairs
 *     std_*                   float64      1     area indices, over the pairs, divided by n - 1
 *     mean_angle              float64      rad   over the pairs
 *     std_angle               float64      rad   divided by n - 1
 *     mean_plane_distance     float64      m     of column "distance" of the pairs
 *     std_plane_distance      float64      m     divided by n - 1
 *     mean_contour_precision  float64      1     over the pairs
 *     mean_contour_recall     float64      1     over the pairs
 *     mean_contour_f1         float64      1     over the pairs
 *     mean_contour_*          float64      m     mean, rms, mean_back and rms_back, over the pairs
 *     mean_hausdorff95        float64      m     over the pairs
 *     mean_hausdorff          float64      m     over the pairs
 *     shift                   float64 x 3  m     taken by "mode" = relative
 *     vertices                uint64       -     homologous vertices
 *     mean_*                  float64      m     bias of dx, dy, dz, distance, along, up and out of
 *                                                the vertices
 *     std_*                   float64      m     of the same about it, divided by n - 1
 *     rms_*                   float64      m     of the same about 0
 *     max_distance            float64      m     largest distance
 *     within_95               float64      1     share of the vertices with covariances that lie in
 *                                                their 95 % ellipsoid
 */
JALON_API JALON_CHECK jalon_status
jalon_model_evaluation_totals(const jalon_model_evaluation* evaluation, jalon_fields** out);

/**
 * The area indices of areas that are already known, e.g. of a printed table: count automatic areas,
 * reference areas and areas of their intersections (m2).
 *
 * - options: operation "indices".
 * - rows: a row each with the columns "area_automatic" to "omission" of
 *   jalon_model_evaluation_pairs.
 * - totals: one row with the columns "area_automatic" to "std_omission" of
 *   jalon_model_evaluation_totals, of all areas.
 * - One of the outputs may be NULL.
 *
 * JALON_ERROR_INVALID_ARGUMENT for an area that is negative or not finite, or an intersection
 * larger than one of its areas.
 */
JALON_API JALON_CHECK jalon_status jalon_area_indices(const double* automatic_m2,
                                                      const double* reference_m2,
                                                      const double* intersection_m2, uint64_t count,
                                                      const jalon_params* options,
                                                      jalon_fields** rows, jalon_fields** totals);
/**
 * The same of two regions of one plane (m). One row with the columns of the rows of
 * jalon_area_indices. O((n + k) log n) for n corners and k crossings.
 *
 * - automatic_uv, reference_uv: rings of corners u, v, packed one after the other, snapped to 0.1
 *   mm. Anticlockwise rings are outlines, whose union is the region; clockwise ones are holes, cut
 *   out of all of it.
 * - automatic_rings, reference_rings: the number of corners of each ring.
 * - options: operation "indices".
 *
 * JALON_ERROR_INVALID_ARGUMENT for a coordinate that is not finite, JALON_ERROR_LIMIT for one
 * beyond 13 km.
 */
JALON_API JALON_CHECK jalon_status jalon_polygon_indices(
    const double* automatic_uv, const uint64_t* automatic_rings, uint64_t automatic_ring_count,
    const double* reference_uv, const uint64_t* reference_rings, uint64_t reference_ring_count,
    const jalon_params* options, jalon_fields** out);
/**
 * Deviations of count vertices from their reference, pair by pair: x, y, z packed.
 *
 * - rows: the columns of jalon_model_evaluation_vertices; "along", "up", "out" and "normalised" are
 *   NaN.
 * - totals: one row with the columns from "vertices" on of jalon_model_evaluation_totals.
 * - One of the outputs may be NULL.
 *
 * JALON_ERROR_INVALID_ARGUMENT for a coordinate that is not finite.
 */
JALON_API JALON_CHECK jalon_status jalon_vertex_deviations(const double* automatic_xyz,
                                                           const double* reference_xyz,
                                                           uint64_t count, jalon_fields** rows,
                                                           jalon_fields** totals);

JALON_END_C

#endif
