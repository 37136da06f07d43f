/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file segmenter.h
 * Segmentation: a cloud in; a label per point and the segments (planes ...) with parameters,
 * covariance and residuals out.
 *
 * A segmenter holds parameters and no data; one thread at a time sets them, several may run it once
 * set. A segmentation is immutable, retains its cloud, and may be read by many threads.
 */
#ifndef JALON_SEGMENTER_H
#define JALON_SEGMENTER_H

#include <jalon/cloud.h>

JALON_BEGIN_C

typedef struct jalon_segmenter jalon_segmenter;
typedef struct jalon_segmentation jalon_segmentation;

/** Orientation classes of planes relative to the main facade (Boulaassal 2010, 3.4.5.2). */
enum {
  JALON_ORIENTATION_NONE = 0,       /**< noise, no plane */
  JALON_ORIENTATION_PARALLEL = 1,   /**< parallel to the main facade: walls, windows */
  JALON_ORIENTATION_VERTICAL = 2,   /**< vertical, perpendicular to it: reveals, posts */
  JALON_ORIENTATION_HORIZONTAL = 3, /**< horizontal: sills, soffits, ground */
  JALON_ORIENTATION_INCLINED = 4    /**< everything else */
};

/** How the side of a plane's normal was found. */
enum {
  JALON_FRONT_NONE = 0,    /**< by convention: level planes upward, others toward the viewer of the
                                wall next to them */
  JALON_FRONT_STATION = 1, /**< toward the stations of its points */
  JALON_FRONT_EVIDENCE = 2 /**< no station is known: by what lies before and behind the wall */
};

/** What a segment is (the type codes of Boulaassal 2010, 5.5.2). */
enum { JALON_PRIMITIVE_PLANE = 1, JALON_PRIMITIVE_SPHERE = 2, JALON_PRIMITIVE_CYLINDER = 3 };

/**
 * method, NULL = "ransac":
 * - "ransac": planes one after the other, the best first, from seeded random draws (Fischler &
 *   Bolles 1981; Schnabel et al. 2007; Boulaassal 2010). With parameter "primitives" also spheres
 *   and cylinders, from two points with normals or from points alone: they compete with the planes
 *   by their number of points, so a column is not taken for strips, and are kept where they turn by
 *   more than the normals of a plane may, few planes do not fit their points as well, and they
 *   stand out from what surrounds them. The tolerance is no narrower than 3 sigma of the cloud's
 *   noisiest surfaces unless it is set (parameter "tolerance_from"); jalon_segmentation_parameters
 *   tells it. O(n log n).
 * - "region_growing": regions grown from the flattest places (Vosselman et al. 2004) over points
 *   with normals: a point joins when its normal is within an angle of the running plane's and it
 *   lies within a distance of that plane (Stamos & Allen 2002), which is refitted as the region
 *   grows; coplanar neighbours are joined, the points left over grow among themselves once more,
 *   and all points are shared out anew among all planes. No random draws: the same cloud gives the
 *   same result. O(n log n); normals included, about as fast as "ransac" and with fewer chance
 *   planes, but it needs surfaces a few points wide and stops at their gaps (then joined up to
 *   merge_gap_m).
 * - "raster_growing": depth images of the cloud, one for each dominant direction of its surfaces,
 *   or the one that parameter "projection" asks for; regions of pixels grown from the flattest
 *   windows by a plane in grey values with running sums, as programs for airborne scans do
 *   (projection, tolerance, borders: the French comparison of three methods of 2006). What lies
 *   behind another surface comes with the next image of the points that are left. For a main facade
 *   that carries everything; narrow parts between two pixels wide and less are lost. O(points +
 *   pixels).
 * - "profiles": parallel slices of the cloud along all three axes or a direction, the points of each
 *   chained and simplified to lines (Douglas & Peucker 1973), lines of neighbouring slices matched
 *   to rectangles, rectangles joined to planes, which then take the points between the slices (the
 *   same comparison). For large facades; a plane must show in three slices. O(n log n).
 * - "triangle_growing": one point of each cell of the tolerance, the local Delaunay triangles of these
 *   (Gopi, Krishnan & Silva 2000; kept where the stars of two corners have them and no edge is longer
 *   than search_m), regions grown over the triangles by distance and angle with running moments (the
 *   same comparison); the points left over grow once more. For complicated shapes. O(n log n). With
 *   "network" = grid the triangles are those between neighbours of a scanner's grid (fields "row" and
 *   "column"; a grid for each station), which needs no search and no projection; clouds without such
 *   grids have local ones all the same.
 * - "split_merge": octree cells split until flat, touching cells merged where one plane fits (Wang &
 *   Tseng 2004); the points left over are split again, without those of the planes found. O(n log n).
 * - "hough": points vote for the planes through them in an accumulator of two angles and a distance
 *   (Hough 1962; Vosselman et al. 2004); each peak is adjusted and followed over all points as the
 *   planes of "ransac" are, and the points left vote anew. No random draws. Time by the number of
 *   voters and planes.
 * - "scan_lines": the rows of a scan cut into straight pieces, pieces grown to planes across rows
 *   (Jiang & Bunke 1994). Rows are the fields "row" and "column" of the cloud, else vertical profiles
 *   by the angles about its stations; JALON_ERROR_UNSUPPORTED where it has neither. O(n log n).
 * Those before this line refine their planes with "global_planarity": segments that hold several planes
 * (the tolerance is wider than their steps) are parted by 2-means of plane equations over cells of the
 * segment, and all points shared out anew (Yu, Ferencz & Malik 2008; Cohen-Steiner et al. 2004).
 * Of all of them a plane that only lines of points span, in the midst of others, is none: beams of a
 * spinning head draw such lines, and any of these lies in some plane.
 * - "survey_codes": the objects that a coded total-station survey describes (master's thesis on
 *   feature codes for terrestrial laser scanning, University of Liege 2021). Parameter "codes" is
 *   the list as text, a line a point: ID;X;Y;Z;code in the cloud's system, where a code is sequence
 *   or sequence.modifier and several codes of a point are joined by +; "codes_unit" is the unit of
 *   its coordinates (m, cm, mm, ft, us-ft). Buildings are prisms of
 *   their upper outline and a low point, hollowed 0.24 m inside it; doors and windows rectangles
 *   from two, three or four points or outlines with straight and curved parts, cut out of the
 *   buildings; gutters cylinders from centre, edge and top, or axes with bends. Parameter "table"
 *   says what codes mean (JSON; see jalon_segmentation_notes); empty = the thesis' table. Each
 *   object is a segment; jalon_segmentation_cloud has its class as the field "classification", in
 *   the place of one that the cloud had: 0 rest, 1 walls, 2 doors, 3 windows, 4 gutters, or with
 *   "classes" = asprs those of LAS. Unknown codes, incomplete and empty objects, points far from
 *   the cloud are warnings of the log and the notes, no errors; a line that cannot be read is
 *   JALON_ERROR_FORMAT. Buildings have no plane (NaN), gutters the cylinder that was measured; a
 *   gutter whose points lie about another place is warned of. With "form" = improved the fronts of
 *   doors and windows and the circles of gutters are found in the cloud, and what lies before a
 *   front is the reveal of its wall. O(points) for the usual few objects about a point.
 * - "target_codes": the objects about coded targets of the same thesis, parameters "codes", "table"
 *   and "classes" alike: walls by planes drawn through one target each, cut above the first gap in
 *   height and in columns lower than a wall; doors as the plane at their target within 2 m; all
 *   windows of a facade in the plane of two targets, which follow one another in the list; gutters
 *   grown from their target. Each takes its points from those that follow, so a door that is flush
 *   with its wall is lost to it, and told. With "form" = improved doors and windows are what lies at
 *   the front of their frames and leaves. Planes like those of the other methods; gutters none.
 *   Seeded. O(points x (walls x draws + doors + facades)).
 */
JALON_API JALON_CHECK jalon_status jalon_segmenter_create(const char* method,
                                                          jalon_segmenter** out);
/** The names of the methods, the default first. Static texts. */
JALON_API JALON_CHECK jalon_status jalon_segmenter_methods(const char* const** names,
                                                           uint64_t* count);
/** A segmenter of its own of the same method, with the same values. */
JALON_API JALON_CHECK jalon_status jalon_segmenter_copy(const jalon_segmenter* segmenter,
                                                        jalon_segmenter** out);
JALON_API jalon_segmenter* jalon_segmenter_retain(jalon_segmenter* segmenter);
JALON_API void jalon_segmenter_release(jalon_segmenter* segmenter);
/** The segmenter's own parameter set: setting it changes the segmenter. The caller releases it. */
JALON_API JALON_CHECK jalon_status jalon_segmenter_params(jalon_segmenter* segmenter,
                                                          jalon_params** out);
/**
 * Segments the cloud. JALON_ERROR_INSUFFICIENT_DATA below 3 points; JALON_ERROR_DEGENERATE when all
 * points are equal or collinear. A cloud without planes, or with fewer points on them than
 * min_points, or without codes, gives JALON_OK and a segmentation without any. Every method and
 * every choice of parameters gives the same status, but for what "scan_lines" needs besides.
 * Repeated points count as often as they occur; points that are not finite never get into a cloud.
 */
JALON_API JALON_CHECK jalon_status jalon_segmenter_run(const jalon_segmenter* segmenter,
                                                       const jalon_cloud* cloud, jalon_task* task,
                                                       jalon_segmentation** out);

JALON_API jalon_segmentation* jalon_segmentation_retain(jalon_segmentation* segmentation);
JALON_API void jalon_segmentation_release(jalon_segmentation* segmentation);
/**
 * One row a point.
 *     column       type     unit  meaning
 *     label        uint32   -     0 = noise, s = row s - 1 of the segments
 *     residual     float32  m     signed distance from its surface
 *     orientation  uint8    -     JALON_ORIENTATION_...
 */
JALON_API JALON_CHECK jalon_status jalon_segmentation_points(const jalon_segmentation* segmentation,
                                                             jalon_fields** out);
/**
 * One row a segment, largest first. What a type lacks is NaN.
 *     column               type          unit    meaning
 *     label                uint32        -       of its points
 *     source_label         int64         -       the label, or for jalon_segmentation_from_labels
 *                                                the field's value
 *     type                 uint8         -       JALON_PRIMITIVE_...
 *     orientation          uint8         -       JALON_ORIENTATION_...
 *     inliers              uint64        points  number of its points
 *     normal               float64 x 3   -       plane: unit normal, toward the viewer (see
 *                                                front_source); cylinder: direction of the axis
 *     offset               float64       m       plane: normal . p = offset
 *     centroid             float64 x 3   m       plane: mean of its core points; sphere: centre;
 *                                                cylinder: point of the axis at mid height
 *     radius               float64       m       of a sphere or cylinder
 *     axis_u               float64 x 3   -       plane: direction of largest extent; cylinder: of
 *                                                the axis
 *     axis_v               float64 x 3   -       plane: normal x axis_u
 *     sigma                float64       m       of the distances of its core points
 *     area                 float64       m2      occupied raster pixels
 *     length_u             float64       m       extent along axis_u
 *     length_v             float64       m       plane: extent along axis_v; cylinder: arc that its
 *                                                points cover
 *     front_source         uint8         -       JALON_FRONT_...: what the side of a plane's normal
 *                                                was taken from
 *     front_confidence     float64       1       probability that the viewer was on that side: by
 *                                                stations the share of the points seen from there;
 *                                                NaN by convention
 *     covariance           float64 x 16  -       row-major; plane: of nx, ny, nz, offset, rank 3;
 *                                                sphere: of centre and radius
 *     cylinder_covariance  float64 x 49  -       row-major, of axis point, direction and radius,
 *                                                rank 5
 *
 * The covariance of a plane that a segmenter found allows for points of other surfaces that meet it
 * at its border and for noise that differs from point to point (mixture of the plane's own points
 * and one-sided others, Torr & Zisserman 2000; covariance after White 1982, below 1 000 points by
 * the jackknife, Hinkley 1977): on a scanned facade of 440 planes from 0.1 to 190 m2 the true plane
 * lies within the 99 % ellipsoid in 97 of 100. Planes of few points (< 20) or almost no noise, and
 * those of jalon_segmentation_from_labels: least squares.
 */
JALON_API JALON_CHECK jalon_status
jalon_segmentation_segments(const jalon_segmentation* segmentation, jalon_fields** out);
/**
 * A new cloud handle with the points' fields attached, ready to be written; shares the coordinates.
 */
JALON_API JALON_CHECK jalon_status jalon_segmentation_cloud(const jalon_segmentation* segmentation,
                                                            jalon_cloud** out);
/**
 * Rotation about Z and shift that put the main facade parallel to the plane OXZ, the station side
 * at -Y. Identity when off.
 */
JALON_API JALON_CHECK jalon_status jalon_segmentation_facade_frame(
    const jalon_segmentation* segmentation, jalon_transform* T_facade_world);

/**
 * The parameters the segmentation was made with as JSON, the tolerance as it was used; "" when it
 * was not made by a segmenter. Valid as long as the handle.
 */
JALON_API JALON_CHECK jalon_status
jalon_segmentation_parameters(const jalon_segmentation* segmentation, const char** out);
/**
 * What a segmentation by codes tells beside its tables, as JSON; "" of the other methods. Valid as
 * long as the handle.
 *
 *     {"method": "survey_codes",
 *      "classes": [{"class": 1, "points": 9000}],
 *      "objects": [{"name": "door 12", "kind": "door", "code": 350, "class": 2, "label": 3,
 *                   "points": 800, "lines": [6, 7], "ids": ["12", "13"],
 *                   "codes": ["350", "350"], "places": [[x, y, z], [x, y, z]],
 *                   "geometry": "two_corners", "hinge": "left",
 *                   "shape": "rectangle", "corners": [[x, y, z], [x, y, z]],
 *                   "low_m": z, "high_m": z}],
 *      "warnings": [{"line": 20, "object": "gutter 21", "text": "has 2 of 3 points: left out"}]}
 *
 * Objects come in the order of their first lines, object i + 1 being the source_label of its
 * segment; label is that of its points, 0 where it holds none; lines, ids, codes and places are those
 * of its surveyed points. shape: none, prism (outline in plan, low_m, high_m), rectangle (corners,
 * low_m, high_m), outline (the same and outline in space), cylinder (axis, radius_m); lengths in
 * metres, places in the cloud's system, as measured, without the margins. hinge: left or right,
 * seen from outside, or unknown. classes are as written to the cloud, those of objects as in the
 * code table.
 *
 * A code table (parameter "table") is
 *
 *     {"name": "survey", "separator": "+",
 *      "modifiers": {"start": 2, "next": 4, "curve": 3, "close": 0, "offset": 8},
 *      "codes": [{"from": 300, "to": 305, "name": "building", "geometry": "prism", "class": 1},
 *                {"from": 350, "name": "door", "geometry": "two_corners", "class": 2,
 *                 "distance_m": 0.04, "hinged": true}]}
 *
 * geometry: ignored, point, line, prism, two_corners, three_points (one of them offset, straight
 * behind the corner whose recessed twin it is), four_points (inclined sill), outline, centre, edge,
 * top (of an upright cylinder, in this order), pipe (linkage of the axis, its offset point on the
 * skin); of targets wall_target, door_target, window_target (two a facade), gutter_target. to:
 * equal to from by default; class: 0 ... 255, 0 by default; distance_m: half-thickness of a door or
 * window, 0.03 by default. Of two openings that hold a point the later row has it.
 */
JALON_API JALON_CHECK jalon_status jalon_segmentation_notes(const jalon_segmentation* segmentation,
                                                            const char** out);
/**
 * Distribution of the signed distances of points to their planes (Boulaassal 2010, 3.4.3.6).
 * JALON_ERROR_NOT_FOUND for an unknown label. O(points).
 *
 * - label: of one segment; 0 = all segments.
 * - bins: 1 to 10000, over +- four sigma.
 *
 * out_bins, one row a bin:
 *     column    type     unit    meaning
 *     lower     float64  m       lower limit
 *     upper     float64  m       upper limit
 *     count     uint64   points  in the bin
 *     expected  float64  points  by the normal distribution of the same mean, sigma and count
 *
 * out_normal, one row:
 *     column           type     unit    meaning
 *     count            uint64   points  with a plane
 *     mean             float64  m       mean distance
 *     sigma            float64  m       standard deviation, unbiased
 *     skewness         float64  -       0 for normal distances
 *     excess_kurtosis  float64  -       0 for normal distances
 *     below            uint64   points  below the first bin
 *     above            uint64   points  above the last bin
 */
JALON_API JALON_CHECK jalon_status
jalon_segmentation_residuals(const jalon_segmentation* segmentation, uint32_t label, uint32_t bins,
                             jalon_task* task, jalon_fields** out_bins, jalon_fields** out_normal);

JALON_END_C

#endif
