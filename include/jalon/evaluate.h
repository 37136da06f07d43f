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
JALON_API JALON_CHECK jalon_status jalon_segmentation_from_labels(const jalon_cloud* cloud, const char* label_field,
                                                      const jalon_params* options, jalon_task* task,
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
                                                   const jalon_params* options, jalon_task* task,
                                                   jalon_evaluation** out);
JALON_API jalon_evaluation* jalon_evaluation_retain(jalon_evaluation* evaluation);
JALON_API void jalon_evaluation_release(jalon_evaluation* evaluation);
/**
 * One row a pair, ascending by reference label: "automatic", "reference" (uint32 labels), "card_automatic" (Card A),
 * "card_reference" (Card SR), "intersection" (I), "commission" (D+ = A \ SR), "omission" (D- = SR \ A) (uint64), "tdr"
 * = I / Card SR, "tda" = I / Card A, "iou" (float64), "angle" (rad, 0 ... pi/2, between the normals), "distance" (m,
 * mean distance of A's points from SR's plane), "offset_difference" (m, signed: A's centroid beyond SR's plane). The
 * last three are NaN where a side has no plane.
 */
JALON_API JALON_CHECK jalon_status jalon_evaluation_pairs(const jalon_evaluation* evaluation, jalon_fields** out);
/**
 * One row an automatic segment, in the order of its labels: "label" (uint32), "source_label" (int64), "points"
 * (uint64), "kept" (uint8; 0 = left out, too small), "partner" (uint32: the reference label of its pair, 0 =
 * unmatched), "parts" (uint32: reference segments that are parts of it), "covered" (uint64: its points that reference
 * segments hold).
 */
JALON_API JALON_CHECK jalon_status jalon_evaluation_automatic(const jalon_evaluation* evaluation, jalon_fields** out);
/** The same of the reference segments. */
JALON_API JALON_CHECK jalon_status jalon_evaluation_reference(const jalon_evaluation* evaluation, jalon_fields** out);
/**
 * One row: counts "pairs", "unmatched_automatic", "unmatched_reference", "left_out_automatic", "left_out_reference",
 * "over_segmented", "under_segmented", "non_segmented" and, summed over the pairs, "card_automatic", "card_reference",
 * "intersection", "commission", "omission" (uint64); of these sums "global_tdr", "global_tda", "global_iou"; over the
 * pairs "mean_tdr", "mean_tda", "mean_iou"; over all kept segments, unmatched ones as 0, "detection" (TDR of the
 * reference) and "accuracy" (TDA of the automatic); "mean_angle", "std_angle", "mean_distance", "std_distance",
 * "mean_offset_difference", "std_offset_difference" (divided by n - 1) (float64).
 */
JALON_API JALON_CHECK jalon_status jalon_evaluation_totals(const jalon_evaluation* evaluation, jalon_fields** out);

/**
 * Confusion of two class fields (whole numbers, any element type) of one cloud; points without a class (NaN), and those
 * whose reference class is among ignored_classes, are left out. Operation "confusion". At most 1024 different classes
 * (JALON_ERROR_LIMIT). Each output may be NULL.
 *
 * classes: one row a class that occurs in either field, ascending: "class" (int64), "reference", "predicted", "correct"
 * (uint64, points), "precision", "recall", "f1", "iou" (float64), "confusion" (uint64 x number of classes: points of
 * the row's reference class that were given each class, in the order of the rows). totals: one row: "points", "correct"
 * (uint64), "accuracy", "mean_precision", "mean_recall", "mean_f1" (over the classes the reference has), "kappa"
 * (float64; Cohen 1960). O(n log n), parallel.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_confusion(const jalon_cloud* cloud, const char* class_field,
                                             const char* reference_field, const jalon_params* options,
                                             jalon_task* task, jalon_fields** classes,
                                             jalon_fields** totals);

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
JALON_API JALON_CHECK jalon_status jalon_model_evaluate(const jalon_model* model, const jalon_model* reference,
                                            const jalon_params* options, jalon_task* task,
                                            jalon_model_evaluation** out);
JALON_API jalon_model_evaluation* jalon_model_evaluation_retain(jalon_model_evaluation* evaluation);
JALON_API void jalon_model_evaluation_release(jalon_model_evaluation* evaluation);
/**
 * One row a pair, ascending by reference: "automatic", "reference" (uint32: rows of the sides' tables);
 * "area_automatic" |SA|, "area_reference" |SR|, "intersection" TP, "excess" FP = |SA \ SR|, "deficit" FN = |SR \ SA|
 * (m2, in the reference's plane); "completeness" TP/|SR|, "correctness" TP/|SA|, "quality" TP/|SR u SA|, "branching"
 * FP/TP, "miss" FN/TP (the two swapped by formulas = thesis; inf where nothing is shared), "failure" FP/|SR|,
 * "omission" FN/|SR|; "angle" (rad, 0 ... pi/2), "distance" (m, of the automatic face's middle beyond the reference's
 * plane), "same_class" (uint8); "contour_precision" (share of the automatic border within the tolerance of the
 * reference), "contour_recall" (the other way), "contour_f1", "contour_mean", "contour_rms" (m, automatic to
 * reference), "contour_mean_back", "contour_rms_back" (m, reference to automatic), "hausdorff95", "hausdorff" (m)
 * (float64).
 */
JALON_API JALON_CHECK jalon_status jalon_model_evaluation_pairs(const jalon_model_evaluation* evaluation,
                                                    jalon_fields** out);
/**
 * One row a face (or opening, or plane) of the automatic model: "face" (uint32: its row in jalon_model_faces, of the
 * largest of several; of a mesh a triangle), "ring" (uint32: row in jalon_model_rings of an opening, else UINT32_MAX),
 * "part", "merged" (uint32: how many faces it stands for), "area" (float64, m2), "kept" (uint8; 0 = left out, too
 * small), "partner" (uint32: row of the reference's table, UINT32_MAX = unmatched). Faces of classes that do not count
 * and those without an area are not listed.
 */
JALON_API JALON_CHECK jalon_status jalon_model_evaluation_automatic(const jalon_model_evaluation* evaluation,
                                                        jalon_fields** out);
/** The same of the reference. */
JALON_API JALON_CHECK jalon_status jalon_model_evaluation_reference(const jalon_model_evaluation* evaluation,
                                                        jalon_fields** out);
/**
 * One row a pair of homologous vertices, ascending by place of the reference: "automatic", "reference" (uint32: rows of
 * jalon_model_vertices), "dx", "dy", "dz" (m, automatic less reference, after the shift of mode = relative), "distance"
 * (m), "along", "up", "out" (m: the same along the reference's largest face there, up it, and along its normal),
 * "normalised" (the deviation against the covariances of the two vertices, sqrt(e^T C^-1 e): below 2.80 in 95 % of the
 * cases where these are right; NaN where neither has one) (float64).
 */
JALON_API JALON_CHECK jalon_status jalon_model_evaluation_vertices(const jalon_model_evaluation* evaluation,
                                                       jalon_fields** out);
/**
 * One row: counts "pairs", "unmatched_automatic", "unmatched_reference", "left_out_automatic", "left_out_reference",
 * "same_class", "vertices" (uint64); sums "area_automatic", "area_reference", "intersection" over all kept faces,
 * unmatched ones included; of each area index "total_..." of these sums (weighted by area), "mean_..." and "std_..."
 * over the pairs; "mean_..." of each contour column; "mean_", "std_angle", "mean_", "std_plane_distance"; "shift"
 * (float64 x 3, m: taken by mode = relative); of each vertex column "mean_..." (bias), "std_..." (n - 1) and "rms_...",
 * and "max_distance"; "within_95" (share of the vertices with covariances that lie in their 95 % ellipsoid) (float64).
 */
JALON_API JALON_CHECK jalon_status jalon_model_evaluation_totals(const jalon_model_evaluation* evaluation,
                                                     jalon_fields** out);

/**
 * The area indices of areas that are already known, e.g. of a printed table: count automatic areas, reference areas and
 * areas of their intersections (m2). Operation "indices". rows: a row each with the columns "area_automatic" to
 * "omission" of jalon_model_evaluation_pairs; totals: the sums, their indices, means and deviations as above. One of
 * the outputs may be NULL. JALON_ERROR_INVALID_ARGUMENT for an area that is negative or not finite, or an intersection
 * larger than one of its areas.
 */
JALON_API JALON_CHECK jalon_status jalon_area_indices(const double* automatic_m2, const double* reference_m2,
                                          const double* intersection_m2, uint64_t count, const jalon_params* options,
                                          jalon_fields** rows, jalon_fields** totals);
/**
 * The same of two regions of one plane (m): rings of corners u, v, packed one after the other, and the number of
 * corners of each ring. Anticlockwise rings are outlines, whose union is the region; clockwise ones are holes, cut out
 * of all of it. Corners are snapped to 0.1 mm. One row with the columns of jalon_area_indices. Operation "indices".
 * JALON_ERROR_INVALID_ARGUMENT for a coordinate that is not finite, JALON_ERROR_LIMIT for one beyond 13 km.
 * O((n + k) log n) for n corners and k crossings.
 */
JALON_API JALON_CHECK jalon_status jalon_polygon_indices(const double* automatic_uv, const uint64_t* automatic_rings,
                                             uint64_t automatic_ring_count, const double* reference_uv,
                                             const uint64_t* reference_rings, uint64_t reference_ring_count,
                                             const jalon_params* options, jalon_fields** out);
/**
 * Deviations of count vertices from their reference, pair by pair: x, y, z packed. rows: the columns of
 * jalon_model_evaluation_vertices, "along", "up" and "out" NaN; totals: their means, deviations and root mean squares.
 * One of the outputs may be NULL. JALON_ERROR_INVALID_ARGUMENT for a coordinate that is not finite.
 */
JALON_API JALON_CHECK jalon_status jalon_vertex_deviations(const double* automatic_xyz, const double* reference_xyz,
                                               uint64_t count, jalon_fields** rows, jalon_fields** totals);

JALON_END_C

#endif
