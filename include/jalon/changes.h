/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file changes.h
 * From distances to changes: connected regions of changed points with what they measure, and from the comparison in
 * both directions what happened to each object.
 */
#ifndef JALON_CHANGES_H
#define JALON_CHANGES_H

#include <jalon/comparer.h>

JALON_BEGIN_C

/**
 * The changed points of a comparison and their connected regions (Girardeau-Montaut 2006, 3.2.4). A
 * comparison without changes gives JALON_OK and a table without rows. O(n log n).
 *
 * - options: operation "regions": "criterion" automatic | threshold | significance | field;
 *   "threshold_m", to which "spacing_share" times the comparison's column "reference_spacing" is
 *   added where it has one; "cell_m", "connectivity", "min_points".
 * - out_points, out_regions: each may be NULL.
 *
 * JALON_ERROR_INVALID_ARGUMENT when the criterion needs a column that the comparison does not have.
 *
 * out_points, one row a point of the comparison:
 *     column   type    unit  meaning
 *     changed  uint8   -     1 = changed
 *     region   uint32  -     its region; 0 = in none
 *
 * out_regions, one row a region, most points first:
 *     column    type         unit  meaning
 *     region    uint32       -     number of the region, from 1 on
 *     points    uint64       -     its points
 *     area      float64      m2    of the sampled surface: the sum of the discs that the points
 *                                  stand for
 *     volume    float64      m3    between the region and the other epoch, see below
 *     mean      float64      m     of its distances
 *     rms       float64      m     of its distances, about 0
 *     extreme   float64      m     its largest distance, with its sign
 *     centroid  float64 x 3  m     mean of its points
 *     box_min   float64 x 3  m     lowest corner of the box around them
 *     box_max   float64 x 3  m     highest corner
 *
 * Of a comparison of method "landslide" (criterion automatic or significance) the regions are its
 * zones, those that went down with a negative "mean"; the area is across the direction, the volume
 * that of the measured cells, those beside the zone among them, and there are besides:
 *     column         type     unit  meaning
 *     volume_sigma   float64  m3    standard deviation of the volume
 *     boundary       float64  m     length of its outline
 *     open_boundary  float64  m     of that, along ground that was not measured
 *
 * Else "volume" is the sum of a prism a point, its disc as seen along its distance times that. Where
 * distances lead tell the columns "difference_x", "_y", "_z" (parameter "differences") or the
 * normals of method "m3c2"; without them they are laid along the normal of the plane through the
 * region, which is right for pits, heaps and slabs and wrong for what is taller than wide. What
 * changed by less than the criterion is not in it, nor is what no point stands for; distances to
 * the nearest surface make it too small beside walls. The volumes of earthworks are those of
 * jalon_cloud_volume.
 */
JALON_API JALON_CHECK jalon_status jalon_comparison_regions(const jalon_comparison* comparison,
                                                            const jalon_params* options,
                                                            jalon_task* task,
                                                            jalon_fields** out_points,
                                                            jalon_fields** out_regions);

/** What happened to an object (Girardeau-Montaut 2006, 1.1 and annex B). */
enum {
  JALON_CHANGE_APPEARANCE = 1,
  JALON_CHANGE_DISAPPEARANCE = 2,
  JALON_CHANGE_DISPLACEMENT = 3,         /**< moved as a whole, clear of where it was */
  JALON_CHANGE_DISPLACEMENT_OVERLAP = 4, /**< the same, within the volume that it took before */
  JALON_CHANGE_DEFORMATION = 5,          /**< no rigid motion explains it; clear of where it was */
  JALON_CHANGE_DEFORMATION_OVERLAP = 6
};

/**
 * What happened, from the comparison in both directions (3.5 of the source).
 *
 * - forward: the later cloud compared with the earlier one; reverse: the earlier with the later.
 *   Both by method "distance", best with the visibility filter.
 * - options: operation "diagnosis" ("criterion", "threshold_m" ...).
 * - out_forward, out_reverse, out_changes: each may be NULL.
 *
 * Changed regions of both are made whole: what hangs together with them, without the planes that go
 * on beyond them. An object changed in both epochs is laid onto itself by a rigid motion (point to
 * plane, Chen & Medioni 1992): where that explains 93 % of the points that could be seen it was
 * displaced, else deformed. An object changed in one epoch only is deformed when its distances grow
 * from nothing, displaced when the other epoch has its twin (97 %), and else appeared or
 * disappeared. JALON_ERROR_INVALID_ARGUMENT for comparisons without the column "nearest".
 *
 * Of two comparisons with "detection" the significant points are changed, with criterion threshold
 * those beyond the threshold besides, and objects are their changed points alone: regions are of one
 * change where one's points have their nearest in the other, where they are one surface moved by the
 * same way, or side by side. A surface that moved before or behind where it was by a tenth of its
 * size at most looks like a deformation, what changed in one epoch alone like a thing that came or
 * went. Explanations are weighed, each with its probability, and the likeliest is told: 1. the thing
 * that changed points are parts of, or that what went and what came within "twin_reach" of its sizes
 * are parts of, is made whole and laid onto itself by a rigid motion; it was displaced where that is
 * more likely than not, by what the motion explains of it and of what changed, by what staying
 * explains as well, by its way, by how far that turns it off what it stands on, and by how alike both
 * are; 2. of what is left each group of regions appeared or disappeared, or was deformed. The cost
 * grows with the changed points. "confidence" is that probability: that this did change, and in this
 * way, overlap or not; a logistic regression on what the stations saw, on distances against
 * threshold, noise and spacing, on shapes and on other changes nearby, fitted to scenes with truth
 * and scaled to kinds of scenes left out. What is as likely wrong as right is left out: it cannot be
 * told.
 *
 * out_forward and out_reverse, one row a point of the comparison:
 *     column   type    unit  meaning
 *     changed  uint8   -     1 = changed
 *     region   uint32  -     its region; 0 = in none
 *     change   uint32  -     row of out_changes counted from 1, unchanged parts of the object too;
 *                            0 = none
 *
 * out_changes, one row a change; the last three are NaN for all but displacements:
 *     column           type          unit  meaning
 *     change           uint32        -     its number, from 1 on
 *     class            uint8         -     JALON_CHANGE_...
 *     confidence       float64       -     0 to 1
 *     points_before    uint64        -     of the object
 *     points_after     uint64        -     of the object
 *     area_before      float64       m2    of its changed surface
 *     area_after       float64       m2    of its changed surface
 *     volume_before    float64       m3    between its changed surface and the other epoch, along
 *                                          the way to the nearest point; see
 *                                          jalon_comparison_regions
 *     volume_after     float64       m3    the same
 *     centroid_before  float64 x 3   m     mean of its points
 *     centroid_after   float64 x 3   m     mean of its points
 *     box_min          float64 x 3   m     lowest corner of the box around both
 *     box_max          float64 x 3   m     highest corner
 *     displacement     float64 x 3   m     of the centroid before
 *     rotation         float64 x 3   rad   rotation vector
 *     covariance       float64 x 36  -     of rotation (rad) and displacement (m), row-major
 */
JALON_API JALON_CHECK jalon_status
jalon_comparison_diagnose(const jalon_comparison* forward, const jalon_comparison* reverse,
                          const jalon_params* options, jalon_task* task, jalon_fields** out_forward,
                          jalon_fields** out_reverse, jalon_fields** out_changes);

/**
 * Outlines of change regions as a model, for maps and drawings: jalon_model_write makes GeoJSON,
 * DXF, OBJ ... of it. Each region is a part, below the first part "changes", with a face for each
 * connected piece of its surface, nearly always one: its points, projected onto the plane through
 * them that fits best (2.5D), are triangulated and the triangles across gaps taken away (alpha
 * shape; Edelsbrunner, Kirkpatrick & Seidel 1983); what borders the others are the rings. Outlines
 * run through the outermost points. A region whose points span no surface is the box around them.
 *
 * - forward_points, reverse_points: what jalon_comparison_regions or jalon_comparison_diagnose gave
 *   for the points of these comparisons.
 * - reverse, reverse_points: may be NULL.
 * - changes: out_changes of a diagnosis, or NULL.
 * - options: operation "change_outlines" ("max_edge_m", "min_opening_area_m2").
 *
 * Parts are named "region 2", of both ways "region 2 after" (forward) or "region 2 before", with
 * "change 1 " before that where a change holds them, and the id of their faces is the row of the
 * change, counted from 1, else the region. The class of a part is "appearance", "disappearance",
 * "displacement_before", "displacement_after", "deformation_before", "deformation_after", or
 * "region" where no change tells: the layer of a DXF. Of method "landslide" the outlines are the
 * cells', of class "depletion" or "accumulation", and there are parts "not measured in the
 * reference", "... in the compared epoch" and "... in either epoch" of class "unmeasured".
 *
 * JALON_ERROR_INVALID_ARGUMENT when the tables do not fit the comparisons. Without regions the
 * model has no faces. O(m log n) for m changed points of n.
 */
JALON_API JALON_CHECK jalon_status jalon_comparison_outlines(
    const jalon_comparison* forward, const jalon_fields* forward_points,
    const jalon_comparison* reverse, const jalon_fields* reverse_points,
    const jalon_fields* changes, const jalon_params* options, jalon_task* task, jalon_model** out);

JALON_END_C

#endif
