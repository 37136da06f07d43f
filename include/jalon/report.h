/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file report.h
 * Drawings and reports of results. All writers replace an existing file only when the new one is whole.
 */
#ifndef JALON_REPORT_H
#define JALON_REPORT_H

#include <jalon/modeller.h>

JALON_BEGIN_C

/** Elevation drawing as SVG: the faces parallel to the facade seen from the front, to scale, axes in metres, a scale
 * bar. Operation "elevation". */
JALON_API JALON_CHECK jalon_status jalon_report_write_elevation(const jalon_segmentation* segmentation,
                                                    const jalon_model* model, const char* path,
                                                    const jalon_params* options, jalon_task* task);
/**
 * Picture of the labelled points, without a model: each segment in its colour (those that meet in different ones),
 * noise grey where no segment lies, seen from the front in the facade frame or from above. A path that ends in ".png"
 * gives the points alone; any other an SVG figure with axes in metres, scale bar, segment numbers and legend around
 * them. Below 2 MB for any number of points. Operation "picture".
 */
JALON_API JALON_CHECK jalon_status jalon_report_write_picture(const jalon_segmentation* segmentation,
                                                  const char* path, const jalon_params* options,
                                                  jalon_task* task);
/**
 * One self-contained HTML page: what was read, parameters, the planes with size, normal, sigma and inliers, the spheres
 * and cylinders with radius and its sigma, times, the elevation, the picture of the labelled points and the residual
 * histogram. model may be NULL: a segmentation alone. notes_json: a JSON object with "title", "input" (text pairs) and
 * "times" (seconds by stage), or NULL. Everything that comes from outside is escaped. Operation "report".
 */
JALON_API JALON_CHECK jalon_status jalon_report_write_html(const jalon_segmentation* segmentation,
                                               const jalon_model* model, const char* notes_json,
                                               const char* path, const jalon_params* options,
                                               jalon_task* task);
/** The same content as JSON text for scripts, without the pictures. model may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_report_write_json(const jalon_segmentation* segmentation,
                                               const jalon_model* model, const char* notes_json,
                                               const char* path, const jalon_params* options,
                                               jalon_task* task);

JALON_END_C

#endif
