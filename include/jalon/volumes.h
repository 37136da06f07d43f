/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file volumes.h
 * Volumes between two states of a ground or an object: cut, fill and what they are made of (Girardeau-Montaut 2006,
 * 5.2).
 */
#ifndef JALON_VOLUMES_H
#define JALON_VOLUMES_H

#include <jalon/cloud.h>
#include <jalon/model.h>

JALON_BEGIN_C

/**
 * Volume between two clouds, by square cells across a direction ("2.5D"): each cell has one height
 * in either state, and the volume is the sum of their differences times the cell's area. Cells
 * should hold some ten points: empty ones are lost to the volume, though "interpolated" fills
 * single gaps. What stands over (below an overhang, under a tree) is not seen by such a grid. O(n +
 * cells).
 *
 * - options: operation "volume" ("direction", "cell_m", "cell_value" mean | median | interpolated,
 *   "dead_band_m").
 * - out_summary, out_cells: each may be NULL.
 *
 * JALON_ERROR_INSUFFICIENT_DATA when a cloud is empty, JALON_ERROR_INVALID_ARGUMENT when both have
 * a CRS and these differ, JALON_ERROR_LIMIT above 2^25 cells.
 *
 * out_summary, one row:
 *     column             type     unit  meaning
 *     cut                float64  m3    what the reference has above the compared state
 *     fill               float64  m3    what the compared state has above the reference
 *     net                float64  m3    fill less cut
 *     sigma              float64  m3    of the net volume, from the scatter of the points within
 *                                       the cells; systematic errors come on top
 *     area               float64  m2    of the cells that both have data in
 *     cut_area           float64  m2    of those that were cut
 *     fill_area          float64  m2    of those that were filled
 *     mean_difference    float64  m     mean change of height
 *     cell               float64  m     side of the cells
 *     cells              uint64   -     both have data
 *     without_reference  uint64   -     the reference has no data there; such cells count nowhere
 *     without_compared   uint64   -     the compared state has none
 *     without_data       uint64   -     neither has, in the rectangle around all
 *
 * out_cells, one row a cell that either state has data in, by rows:
 *     column            type         unit  meaning
 *     column            uint32       -     of the grid
 *     row               uint32       -     of the grid
 *     xyz               float64 x 3  m     its centre, at the height of the compared state if that
 *                                          has one
 *     status            uint8        -     0 both have data, 1 the reference has none, 2 the
 *                                          compared state has none
 *     difference        float64      m     compared state above reference; NaN unless both
 *     volume            float64      m3    difference times the area of the cell
 *     reference_points  uint32       -     points of the reference
 *     compared_points   uint32       -     points of the compared state
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_volume(const jalon_cloud* reference,
                                                      const jalon_cloud* compared,
                                                      const jalon_params* options, jalon_task* task,
                                                      jalon_fields** out_summary,
                                                      jalon_fields** out_cells);
/**
 * Volume between two models, the same way round.
 *
 * - Two closed surfaces ("surfaces" automatic or closed): what the compared one encloses less what
 *   the reference encloses, by the divergence theorem, exact. Closed is what has along each side as
 *   many triangles in one direction as in the other, corners of equal coordinates being one.
 *   out_cells has no columns.
 * - Else, or with "surfaces" = prisms: square prisms along the direction from the topmost surface
 *   of one to that of the other, through the centre of each cell ("cell_m" 0: a 500th of the larger
 *   extent). Both outputs as of jalon_cloud_volume, points being 1 where there is a surface.
 *
 * JALON_ERROR_DEGENERATE when "closed" is asked for and one is not, with how many sides are to
 * blame.
 *
 * out_summary of both, one row, behind the columns of jalon_cloud_volume where there are prisms:
 *     column            type     unit  meaning
 *     net               float64  m3    compared less reference
 *     reference_volume  float64  m3    that the reference encloses; NaN unless closed
 *     compared_volume   float64  m3    that the compared model encloses; NaN unless closed
 */
JALON_API JALON_CHECK jalon_status jalon_model_volume(const jalon_model* reference,
                                                      const jalon_model* compared,
                                                      const jalon_params* options, jalon_task* task,
                                                      jalon_fields** out_summary,
                                                      jalon_fields** out_cells);
/**
 * Points on all surfaces of a model, uniform by area and without noise, for comparing a model with
 * a model: sample one and compare the points with the other (jalon_comparer_run_model). Every face
 * gets its share to within two points a triangle. The CRS is the model's. Same seed, same bits,
 * whatever the threads.
 *
 * - options: operation "model_sample" ("points" or "spacing_m", "chord_error_m", "seed").
 *
 * JALON_ERROR_INSUFFICIENT_DATA for a model without surfaces, JALON_ERROR_DEGENERATE when they have
 * no area.
 *
 * Fields:
 *     column    type         unit  meaning
 *     normal    float32 x 3  -     of the face
 *     face      uint32       -     as jalon_comparer_run_model gives it; UINT32_MAX = a triangle of
 *                                  the mesh
 *     triangle  uint32       -     UINT32_MAX = a face
 *     part      uint32       -     UINT32_MAX = none
 */
JALON_API JALON_CHECK jalon_status jalon_model_sample(const jalon_model* model,
                                                      const jalon_params* options, jalon_task* task,
                                                      jalon_cloud** out);

JALON_END_C

#endif
