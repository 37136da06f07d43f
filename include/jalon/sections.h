/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file sections.h
 * Sections of a cloud: the lines in which planes cut what was scanned, as a draughtsman draws them of floors, tunnels
 * and streets.
 *
 * Sections are immutable and may be read by many threads.
 */
#ifndef JALON_SECTIONS_H
#define JALON_SECTIONS_H

#include <jalon/cloud.h>
#include <jalon/fields.h>
#include <jalon/params.h>
#include <jalon/task.h>

JALON_BEGIN_C

typedef struct jalon_sections jalon_sections;

/**
 * Cuts a cloud by planes and draws the lines that its points show in each. The points within half of "thickness_m" are
 * thinned by cells of "tolerance_m" (larger ones where they are sparse) and chained up to "gap_m"; chains are
 * simplified within "tolerance_m" (Douglas & Peucker 1973), each straight piece is fitted to its points by least
 * squares, and corners are where neighbours meet. What lies in the plane as a face, such as a floor in a level section,
 * has no line.
 *
 * - alignment: NULL, or alignment_count points x, y, z (m) of an axis in plan (z has no say): upright planes
 *   perpendicular to it, at its stations; at a bend, to the piece that begins there. They look along it: the offset is
 *   positive to the right. "reach_m" ends them on both sides.
 * - options: operation "sections". Without an alignment the planes lie across "direction": 0, 0, 1, the default, gives
 *   level ones at heights, seen from above; upright ones look along it. "at_m" has the places, "step_m" adds its
 *   multiples as far as cloud or alignment go; without both, each metre. Places are in the cloud's own coordinates.
 *
 * A point may be of several sections. Where a surface meets a plane at an angle its points are slid along it onto the
 * plane; at less than 30 degrees between them lines become broad or double, the more the thicker the section.
 * O(n log n). Same bits whatever the order of the points and the threads.
 *
 * JALON_ERROR_INSUFFICIENT_DATA: no points. JALON_ERROR_INVALID_ARGUMENT: a station beyond the alignment, an alignment
 * without extent in plan. JALON_ERROR_LIMIT: more than 100 000 sections. A section that
 * meets nothing is there, without lines.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_sections(const jalon_cloud* cloud,
                                                        const double* alignment,
                                                        uint64_t alignment_count,
                                                        const jalon_params* options,
                                                        jalon_task* task, jalon_sections** out);
JALON_API jalon_sections* jalon_sections_retain(jalon_sections* sections);
JALON_API void jalon_sections_release(jalon_sections* sections);

/**
 * One row a section, by its place:
 *     column           type         unit  meaning
 *     at               float64      m     height, place along the direction, or station
 *     origin           float64 x 3  m     of offsets in the plane; of an alignment: on it, at height 0
 *     axis_u           float64 x 3  -     to the right
 *     axis_v           float64 x 3  -     upward in the drawing
 *     points           uint64       -     points within half the thickness
 *     points_on_lines  uint64       -     points that lines were made of
 *     lines            uint64       -
 *     length           float64      m     of the lines
 *     rms              float64      m     of the points' distances from their lines; NaN without lines
 *     max              float64      m     largest distance of a point from its line; NaN without lines
 *     cell             float64      m     side of the cells that the points were thinned by
 */
JALON_API JALON_CHECK jalon_status jalon_sections_summary(const jalon_sections* sections,
                                                          jalon_fields** out);
/**
 * One row a line, section by section:
 *     column    type     unit  meaning
 *     section   uint32   -     row of the section
 *     first     uint64   -     row of the first vertex
 *     vertices  uint32   -
 *     closed    uint8    -     1: the last vertex is joined to the first, which stands once
 *     points    uint64   -     that it was made of
 *     length    float64  m
 *     rms       float64  m     of the points' distances from it
 *     max       float64  m     largest distance of a point from it
 */
JALON_API JALON_CHECK jalon_status jalon_sections_lines(const jalon_sections* sections,
                                                        jalon_fields** out);
/**
 * One row a vertex, line by line:
 *     column   type         unit  meaning
 *     section  uint32       -     row of the section
 *     line     uint32       -     row of the line
 *     xyz      float64 x 3  m     in space
 *     uv       float64 x 2  m     from the section's origin along its axes: offset and height of an alignment's
 */
JALON_API JALON_CHECK jalon_status jalon_sections_vertices(const jalon_sections* sections,
                                                           jalon_fields** out);
/**
 * The name of a section, "Z 12.500", "D 3.000" or "STATION 25.000": as its layer has it, with _ for the blank. Lives as
 * long as the sections. JALON_ERROR_INVALID_ARGUMENT: no such section.
 */
JALON_API JALON_CHECK jalon_status jalon_sections_name(const jalon_sections* sections, uint64_t i,
                                                       const char** out);
/** The parameters they were cut with, as JSON; lives as long as the sections. */
JALON_API JALON_CHECK jalon_status jalon_sections_parameters(const jalon_sections* sections,
                                                             const char** out);
/**
 * Writes the sections by the end of the name.
 *
 * - .dxf: where they are in space, in metres, a layer a section, polylines that are closed where the lines are.
 * - .svg: a drawing in millimetres to a usual scale: level sections as one plan in colours, others side by side.
 * - options: operation "write" ("dxf_version").
 *
 * JALON_ERROR_UNSUPPORTED: another end.
 */
JALON_API JALON_CHECK jalon_status jalon_sections_write(const jalon_sections* sections,
                                                        const char* path,
                                                        const jalon_params* options,
                                                        jalon_task* task);

JALON_END_C

#endif
