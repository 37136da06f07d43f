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
 * Volume between two clouds, by square cells across a direction ("2.5D"): each cell has one height in either state, and
 * the volume is the sum of their differences times the cell's area. options: operation "volume" (direction, cell_m,
 * cell_value mean | median | interpolated, dead_band_m). Cells should hold some ten points: empty ones are lost to the
 * volume, though "interpolated" fills single gaps. What stands over (below an overhang, under a tree) is not seen
 * by such a grid. JALON_ERROR_INSUFFICIENT_DATA when a cloud is empty, JALON_ERROR_INVALID_ARGUMENT when both have a
 * CRS and these differ, JALON_ERROR_LIMIT above 2^25 cells.
 *
 * out_summary, one row (float64 but for the counts): "cut", "fill" (m3: what the reference has above the compared
 * state, and the compared state above the reference), "net" (m3: fill less cut), "sigma" (m3: of the net volume, from
 * the scatter of the points within the cells; systematic errors come on top), "area", "cut_area", "fill_area" (m2),
 * "mean_difference" (m), "cell" (m), "cells" (uint64: both have data), "without_reference", "without_compared"
 * (uint64: one state has no data there; such cells count nowhere), "without_data" (uint64: neither has, in the
 * rectangle around all).
 *
 * out_cells, one row a cell that either state has data in, by rows: "column", "row" (uint32), "xyz" (float64 x 3, m:
 * its centre, at the height of the compared state if that has one), "status" (uint8: 0 both have data, 1 the reference
 * has none, 2 the compared state has none), "difference" (float64, m; NaN unless both), "volume" (float64, m3),
 * "reference_points", "compared_points" (uint32). Each output may be NULL. O(n + cells).
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_volume(const jalon_cloud* reference, const jalon_cloud* compared,
                                          const jalon_params* options, jalon_task* task,
                                          jalon_fields** out_summary, jalon_fields** out_cells);
/**
 * Volume between two models, the same way round. Two closed surfaces ("surfaces" automatic or closed): what the
 * compared one encloses less what the reference encloses, by the divergence theorem, exact; the summary has then "net",
 * "reference_volume" and "compared_volume" alone and out_cells no columns. Closed is what has along each side as many
 * triangles in one direction as in the other, corners of equal coordinates being one. Else, or with "prisms": square
 * prisms along the direction from the topmost surface of one to that of the other, through the centre of each cell
 * (cell_m 0: a 500th of the larger extent); outputs as of jalon_cloud_volume, points being 1 where there is a surface.
 * JALON_ERROR_DEGENERATE when "closed" is asked for and one is not, with how many sides are to blame.
 */
JALON_API JALON_CHECK jalon_status jalon_model_volume(const jalon_model* reference, const jalon_model* compared,
                                          const jalon_params* options, jalon_task* task,
                                          jalon_fields** out_summary, jalon_fields** out_cells);
/**
 * Points on all surfaces of a model, uniform by area and without noise, for comparing a model with a model: sample one
 * and compare the points with the other (jalon_comparer_run_model). options: operation "model_sample" (points or
 * spacing_m, chord_error_m, seed). Every face gets its share to within two points a triangle. Fields: "normal" (float32
 * x 3: of the face), "face", "triangle", "part" (uint32, as jalon_comparer_run_model gives them). The CRS is the
 * model's. JALON_ERROR_INSUFFICIENT_DATA for a model without surfaces, JALON_ERROR_DEGENERATE when they have no area.
 * Same seed, same bits, whatever the threads.
 */
JALON_API JALON_CHECK jalon_status jalon_model_sample(const jalon_model* model, const jalon_params* options,
                                          jalon_task* task, jalon_cloud** out);

JALON_END_C

#endif
