/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file report.h
 * Drawings and reports of results. All writers replace an existing file only when the new one is whole.
 *
 * Pages show what they are about in three dimensions too: the points (at most "viewer_points" of them, 1 000 000 by
 * default, evenly taken; 0: no view) by segment, residual or distance on the page's scale, height, intensity or colour;
 * outlines and openings with their names; a click tells what is there, two clicks a distance; sections; several clouds
 * together or side by side; the view is kept in the link. It is drawn by WebGL 2 from the page itself: nothing is
 * loaded, and the page's policy forbids it. It is not printed; without script or WebGL a line says so.
 */
#ifndef JALON_REPORT_H
#define JALON_REPORT_H

#include <jalon/adjustment.h>
#include <jalon/clearance.h>
#include <jalon/comparer.h>
#include <jalon/modeller.h>
#include <jalon/network.h>
#include <jalon/registrar.h>

JALON_BEGIN_C

/**
 * Elevation drawing as SVG, a sheet to print at its scale: the model seen from the front of its main facade, or one
 * of its facades alone from its own front (option "facade"; a model of several facades has one drawing each). Faces
 * are filled by their depth before or behind the main plane (red in front, green behind; Boulaassal 2010, 4.4.1),
 * arcs are arcs. Openings (parts of class window, door, opening) have a contour of their class and the tag of their
 * type, W1 D1 O1 ...; copied ones are dashed, those in which nothing was seen crossed; parts of class no_data, and
 * holes of which nothing is known, are hatched. Around it: chains of dimensions in metres (columns of openings, their
 * axes, the ground floor where it differs, sills and heads, overall), height marks above the lowest ground, axes in
 * metres, legend, table of the types of openings, scale bar, plan of the view with north, title block. Where numbers
 * have no room at the scale the narrowest openings are left out of their chain. A model that names no openings shows
 * plane numbers instead of types. Operation "elevation"; JALON_ERROR_INVALID_ARGUMENT for a facade that the model
 * does not have.
 */
JALON_API JALON_CHECK jalon_status
jalon_report_write_elevation(const jalon_segmentation* segmentation, const jalon_model* model,
                             const char* path, const jalon_params* options, jalon_task* task);
/**
 * Picture of the labelled points, without a model: each segment in its colour (those that meet in different ones),
 * noise grey where no segment lies, seen from the front in the facade frame or from above. A path that ends in ".png"
 * gives the points alone; any other an SVG figure with axes in metres, scale bar, segment numbers and legend around
 * them. Below 2 MB for any number of points. Operation "picture". As SVG the plan of a segmentation by codes shows the
 * points in the colours of their classes, the coded objects, and the surveyed points with their codes.
 */
JALON_API JALON_CHECK jalon_status
jalon_report_write_picture(const jalon_segmentation* segmentation, const char* path,
                           const jalon_params* options, jalon_task* task);
/**
 * Orthoimage of a facade in true scale: its points seen along the horizontal of its front plane (the largest wall), a
 * pixel showing the mean of those nearest to the viewer: their colour where the cloud has one, else their intensity,
 * else their distance before the plane (blue behind, red before it). Points far before or behind the plane are left
 * out; pixels without points have no data. By the extension of the path:
 *
 * - png: with transparent pixels where there are no data, and a world file of the same name with extension pgw, whose
 *   coordinates are those of the elevation drawing (x from the left end of the first facade, several side by side; y
 *   the height): "dxf_images" of operation "write" links it into a drawing.
 * - tif, tiff: GeoTIFF in the same coordinates, a local system in metres: colours in 8 bits with alpha, else intensity
 *   or distance (m) as float32 with a no-data value.
 *
 * Operation "orthoimage". JALON_ERROR_DEGENERATE for a model whose facade has no upright face,
 * JALON_ERROR_INVALID_ARGUMENT for a facade that the model does not have, JALON_ERROR_LIMIT for more than
 * 64 million pixels. O(points + pixels).
 */
JALON_API JALON_CHECK jalon_status
jalon_report_write_orthoimage(const jalon_segmentation* segmentation, const jalon_model* model,
                              const char* path, const jalon_params* options, jalon_task* task);
/**
 * One self-contained HTML page: what was read, parameters, the planes with size, normal, sigma and
 * inliers, the spheres and cylinders with radius and its sigma, times, the elevations, the picture
 * of the labelled points and the residual histogram; of a model the types of its openings, each
 * opening with width, height and depth and their standard deviations (propagated from the
 * covariances of corners and planes), and the tree of parts with what they are known from; the
 * precision of each plane (sigma of a point, of the normal, of the place). Everything that comes
 * from outside is escaped. Of a segmentation by codes the page has the plan, the view, warnings, classes and the table
 * of objects instead.
 *
 * - model: may be NULL: a segmentation alone.
 * - notes_json: NULL, or a JSON object with "title", "input" (text pairs), "scanner" (parameters of
 *   operation "precision": adds to each plane what the scanner makes of its points; every point
 *   needs a station) and "times" (seconds by stage).
 * - options: operation "report".
 */
JALON_API JALON_CHECK jalon_status jalon_report_write_html(const jalon_segmentation* segmentation,
                                                           const jalon_model* model,
                                                           const char* notes_json, const char* path,
                                                           const jalon_params* options,
                                                           jalon_task* task);
/** The same content as JSON text for scripts, without the pictures. Unknown numbers are null. model may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_report_write_json(const jalon_segmentation* segmentation,
                                                           const jalon_model* model,
                                                           const char* notes_json, const char* path,
                                                           const jalon_params* options,
                                                           jalon_task* task);

/**
 * The points of a comparison in the colours of their distances: signed ones from blue over white to red, others from
 * pale yellow to dark red; hidden points pink, those without a value grey where nothing else lies. A path that ends in
 * ".png" gives the points alone, any other an SVG figure with axes in metres, scale bar and colour scale. Operation
 * "deviation_picture". O(n).
 */
JALON_API JALON_CHECK jalon_status jalon_report_write_deviations(const jalon_comparison* comparison,
                                                                 const char* path,
                                                                 const jalon_params* options,
                                                                 jalon_task* task);
/**
 * Histogram of the distances as SVG with the noise law of those below the threshold (Weibull, Girardeau-Montaut 2006,
 * 3.4; of signed ones normal) and the threshold, of signed ones on both sides. The axis shows their body, six robust
 * standard deviations about the median unless limit_m is given, and counts what lies beyond. Operation
 * "comparison_report" (bins, threshold_m, limit_m).
 */
JALON_API JALON_CHECK jalon_status jalon_report_write_histogram(const jalon_comparison* comparison,
                                                                const char* path,
                                                                const jalon_params* options,
                                                                jalon_task* task);
/**
 * One self-contained HTML page on a comparison: summary of both directions, their pictures side by
 * side on one colour scale with the outlines and numbers of what changed, histograms with noise law
 * and threshold, the table of regions or changes, what is significant and how far that is, what the
 * method tells of sampling error, parameters, times, and of each of the first 40 changes a page with
 * its place in both epochs. Outlines are of points beyond threshold_m or, where that is 0, of the
 * significant ones.
 *
 * - reverse: may be NULL: one direction.
 * - changes: what jalon_comparison_regions or jalon_comparison_diagnose gave, or NULL.
 * - notes_json: as in jalon_report_write_html.
 * - options: operation "comparison_report".
 */
JALON_API JALON_CHECK jalon_status jalon_report_write_comparison(
    const jalon_comparison* forward, const jalon_comparison* reverse, const jalon_fields* changes,
    const char* notes_json, const char* path, const jalon_params* options, jalon_task* task);

/**
 * One self-contained HTML page on the run of a gauge: least clearance, the clearance along the way, a table of the
 * tight places (each the tightest obstacle within "apart_m"), at the tightest of them sections across the travel with
 * the outline of the gauge, the points of the cloud and the cut of the model, to scale, and cloud and model (as points
 * on its surface) in the colours of their clearances.
 *
 * - places, intervals: what jalon_gauge_sweep or jalon_gauge_sweep_model gave.
 * - pieces, hull_points: of jalon_gauge_sweep; gauge: of jalon_gauge_sweep_model. piece_count 0 and gauge NULL:
 *   sections without the gauge's outline; both: those of both.
 * - poses: those of the sweep.
 * - cloud, model: those of the sweep, or NULL: without its points, without its cuts.
 * - notes_json: as in jalon_report_write_html.
 * - options: operation "clearance_report"; "margin_m" is that of the sweep.
 *
 * JALON_ERROR_INVALID_ARGUMENT for other tables. O(sections (points + triangles)).
 */
JALON_API JALON_CHECK jalon_status jalon_report_write_clearance(
    const jalon_fields* places, const jalon_fields* intervals, const jalon_gauge_piece* pieces,
    uint64_t piece_count, const double* hull_points, uint64_t hull_point_count,
    const jalon_model* gauge, const jalon_transform* poses, uint64_t pose_count,
    const jalon_cloud* cloud, const jalon_model* model, const char* notes_json, const char* path,
    const jalon_params* options, jalon_task* task);

/**
 * One self-contained HTML page on a registration: whether it converged or why it stopped, the pose
 * and what it is worth, its six directions from the weakest, the residuals of up to 1 000 pairs,
 * histograms of the distances before and after, the convergence, parameters, times. O(n log n).
 *
 * - reference, moving: the clouds, for the histograms; either may be NULL.
 * - notes_json: as in jalon_report_write_html.
 * - options: operation "registration_report".
 */
JALON_API JALON_CHECK jalon_status jalon_report_write_registration(
    const jalon_registration* registration, const jalon_cloud* reference, const jalon_cloud* moving,
    const char* notes_json, const char* path, const jalon_params* options, jalon_task* task);

/**
 * One self-contained HTML page on an adjustment of a drive and a model: whether it converged, its
 * test, the plan with the drive as given (red) and adjusted (green, its corrections and 95 %
 * ellipses enlarged by a stated factor), standard deviations and corrections along the drive, the
 * distances of the matched points with Shapiro and Wilk's test, what became of the points, the
 * strips that moved most, convergence, parameters, times. O(n log n).
 *
 * - truth: the drive as it was where that is known, e.g. of a virtual scan (blue), or NULL.
 * - notes_json: as in jalon_report_write_html.
 * - options: operation "adjustment_report".
 */
JALON_API JALON_CHECK jalon_status jalon_report_write_adjustment(
    const jalon_adjustment* adjustment, const jalon_trajectory* truth, const char* notes_json,
    const char* path, const jalon_params* options, jalon_task* task);

/**
 * A total-station network. A path that ends in ".svg" gives the plan alone: stations, fixed, weak and sighted points,
 * sights (those with an outlier red) and 95 % ellipses enlarged by a stated factor, north up. Any other is one
 * self-contained HTML page: the global test, the plan, reliability (Baarda 1968), points with standard deviations and
 * ellipses, observations from the largest normalised residual, parameters, times. O(n log n).
 *
 * - notes_json: as in jalon_report_write_html.
 */
JALON_API JALON_CHECK jalon_status jalon_report_write_network(const jalon_network* network,
                                                              const char* notes_json,
                                                              const char* path, jalon_task* task);

JALON_END_C

#endif
