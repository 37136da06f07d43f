/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file modeller.h
 * Modelling: a cloud and its segmentation in, a vector model out.
 *
 * A modeller holds parameters and no data; one thread at a time sets them, several may run it once set.
 */
#ifndef JALON_MODELLER_H
#define JALON_MODELLER_H

#include <jalon/model.h>
#include <jalon/segmenter.h>

JALON_BEGIN_C

typedef struct jalon_modeller jalon_modeller;

/**
 * method (NULL = "outlines"):
 * - "outlines": one face with openings a plane, each plane by itself.
 * - "facade": walls with windows and doors, their reveals and joinery, and the elements before and behind them, in a
 *   tree of parts. The tree: [building, when there are several facades ->] facade -> wall -> window, door, gateway,
 *   shop_front, vent, recess or opening -> reveal, joinery; no_data under its wall; sill, cornice, string_course,
 *   base_course, post, ground, roof and element under their facade (Boulaassal 2010, 4.4.1). Edges near another plane
 *   run along the line in which both planes meet, and ends that meet there are one vertex; corners carry covariances.
 *   With "solids" the walls are closed solids of "thickness_m", by default the median depth of the facade's openings.
 * - "cell_decomposition": as "facade", with openings by the baseline of the literature (Boehm, Becker & Haala 2007;
 *   Haala, Becker & Kada 2006): upright and level lines through "edge_length_m" of the wall's ends part the wall into
 *   cells, and cells with less wall than "wall_share" are openings. What something hid is told as an opening too.
 * - "extrusion": the walls alone, extruded inward by that thickness, with the reveals of their openings (4.4.2).
 *   JALON_ERROR_INSUFFICIENT_DATA when no opening tells the depth and thickness_m is 0.
 * - "coded_objects": what the codes of a segmentation by "survey_codes" or "target_codes" describe, as measured; names
 *   end with the code: "window 122 (361)". Buildings are closed prisms from their low point to their highest corner
 *   (parts wall, top and foot); windows and doors cut holes with reveals into the wall that they stand in, up to 1 m
 *   behind it, with joinery at the frame; one that no wall holds is a face by itself. Gutters are pipes within
 *   "chord_m" of the round. Of targets: walls and doors as the rectangles of their points, windows of a facade one each
 *   where gaps of "gap_m" part them, gutters as circles fitted in plan. JALON_ERROR_INSUFFICIENT_DATA for segments of
 *   other methods.
 *
 * Method "facade" names parts by position, size, depth and orientation:
 * - facade: upright parallel walls near each other; the largest comes first. wall: an upright plane of min_wall_area_m2
 *   that does not lie in the openings of another wall.
 * - A hole of a wall, or a notch in its lower border, is an opening when it was seen through, when reveals were
 *   measured in it, when something parallel to the wall fills it, or at last by its shape; the part's evidence says
 *   which. What only things in front hide is no opening but no_data. Rays from the stations decide where the cloud has
 *   stations with poses, else what lies before and behind.
 * - The class of an opening (window, door, gateway, shop_front, vent, recess) is the likeliest by multinomial logistic
 *   regression (Bishop 2006, 4.3.4) from its size, its height over the ground, the depth of its joinery, how much of it
 *   the joinery fills and what lies behind (glass), its neighbours of the same size, arcs, and walls that stand back in
 *   it; fitted on 100 facades of the scene "grammar" and two real ones. Its probability is column class_confidence of
 *   jalon_model_parts; below "min_class_confidence" (0.7), and where it is likeliest none of these, it is an "opening".
 * - What of a wall nobody measured: "fill" = small (default) draws wall over places whose longer side is up to
 *   "fill_spacings" (12) spacings of the wall's points; the others are holes of the wall's face, or notches, and a part
 *   no_data has the face that fills them. never: all are. outline: wall all over its outline; parts no_data without
 *   faces say where nobody measured it. No area is wall and no_data at once. What is below "min_opening_area_m2" is not
 *   looked at and is wall in any case. With "evidence" walls end where nothing more was measured of them; what is below
 *   a wall and above its foot there, and shows nothing or something before the wall, is no_data beside its faces.
 * - depth of an opening: median distance of its joinery (the frame, where it shows) behind the wall (4.4.2); its pane
 *   has the outline of the hole, moved along the wall's normal; reveals join both, arcs as planar strips within 1 mm.
 *   The wall's hole, the reveals and the pane share vertices; column "part" of the ring names the opening.
 * - ground: level, 2 m2 and more, at the foot and before the facade. sill: below an opening, up to 0.5 m high, before
 *   the wall. roof: level or inclined, 4 m2 and more, at the top, behind the front. cornice, base_course,
 *   string_course: 3 times as long as high, before the wall, at its top, its foot, between. post: before the wall, up
 *   to 1 m wide, 3 times as high. element: all else.
 * - Openings are numbered by row from below and place from the left ("window 2.3"), other parts from the left.
 *
 * With parameter "evidence" (the default) walls and openings are found otherwise:
 * - Each upright plane becomes cells of 2.2 spacings that say what the cloud shows there: measured, seen through (a
 *   point behind it), covered by relief up to 0.1 m before it, hidden, nothing. Rays from the stations decide where the
 *   cloud has stations with poses, else what lies straight before and behind.
 * - facade: upright parallel walls near each other; the largest comes first. wall: an upright plane of
 *   min_wall_area_m2, with all pieces of it that lie in one plane, whatever gap parts them; not what fills another
 *   wall's openings, covers it (surrounds, panels, parapets of balconies) or is a room's wall seen through them.
 * - Openings are the shapes (rectangle, trapezium, triangle, gable, arch, circle) that explain the cells best: boxes of
 *   the greatest score (Bentley 1984), then the shape by minimal description length (Rissanen 1978); curved and sloping
 *   heads need wall measured along them. Lights parted by a mullion are one opening. What was seen through is an
 *   opening; what is empty is one only with wall measured all round it and above the foot; the part's evidence says
 *   how much is known. Where the contour of the wall's points has the same opening it is drawn by its points, as above.
 *   The rest is no_data, as "fill" says.
 */
JALON_API JALON_CHECK jalon_status jalon_modeller_create(const char* method, jalon_modeller** out);
/** The names of the methods, the default first. Static texts. */
JALON_API JALON_CHECK jalon_status jalon_modeller_methods(const char* const** names,
                                                          uint64_t* count);
/** A modeller of its own of the same method, with the same values. */
JALON_API JALON_CHECK jalon_status jalon_modeller_copy(const jalon_modeller* modeller,
                                                       jalon_modeller** out);
JALON_API jalon_modeller* jalon_modeller_retain(jalon_modeller* modeller);
JALON_API void jalon_modeller_release(jalon_modeller* modeller);
/** The modeller's own parameter set: setting it changes the modeller. The caller releases it. */
JALON_API JALON_CHECK jalon_status jalon_modeller_params(jalon_modeller* modeller,
                                                         jalon_params** out);
/**
 * cloud must be the cloud that was segmented, or have the same points. A segmentation without segments gives a model
 * without faces.
 */
JALON_API JALON_CHECK jalon_status jalon_modeller_run(const jalon_modeller* modeller,
                                                      const jalon_cloud* cloud,
                                                      const jalon_segmentation* segmentation,
                                                      jalon_task* task, jalon_model** out);

/**
 * The contour of a segment by long edges, to the letter of Boulaassal 2010, 4.2.3: the curve of sorted edge lengths of
 * its Delaunay triangulation, a threshold on it, and the end points of longer edges. (The modellers bound triangles
 * instead, by parameter "contour": their rings close and reach into corners.) Operation "long_edges".
 *
 * - label: of the segment, a plane; JALON_ERROR_NOT_FOUND for an unknown one. out_summary: may be NULL.
 *
 * out_lengths, one row an edge, ascending:
 *     column  type     unit  meaning
 *     length  float64  m     of the edge
 *
 * out_points, one row a contour point, outer and inner contours together:
 *     column  type    unit  meaning
 *     point   uint64  -     index in the cloud, ascending
 *
 * out_summary, one row:
 *     column     type     unit    meaning
 *     spacing    float64  m       typical distance of neighbouring points
 *     knee       float64  m       where the curve turns, 2 to 5 spacings
 *     threshold  float64  m       "threshold_m", or the knee
 *     edges      uint64   -       of the triangulation
 *     longer     uint64   -       edges beyond the threshold
 *     points     uint64   points  rows of out_points
 *
 * JALON_ERROR_DEGENERATE for points on one line. O(n log n).
 */
JALON_API JALON_CHECK jalon_status jalon_segmentation_long_edges(
    const jalon_segmentation* segmentation, uint32_t label, const jalon_params* options,
    jalon_task* task, jalon_fields** out_lengths, jalon_fields** out_points,
    jalon_fields** out_summary);

JALON_END_C

#endif
