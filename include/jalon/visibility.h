/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file visibility.h
 * What the scanners of a reference cloud could see: depth maps of its stations, and labels of the points of another
 * cloud. Where a scanner did not look, a nearest neighbour says nothing of change (Girardeau-Montaut 2006, 2.3.3 and
 * annex E.1).
 *
 * A depth map is a range image in the two angles of the scanner: horizontal clockwise from its +Y axis toward +X,
 * vertical from its horizon. Its cells are depth_cell_factor angular steps wide; these are estimated from the points,
 * whatever their order. Holes are filled from their neighbours. Between the points of neighbouring cells the surface is
 * taken to go on, up to edges in depth, so that ground under grazing rays does not hide itself.
 *
 * Every point of the reference must belong to a station with a pose: JALON_ERROR_INVALID_ARGUMENT otherwise. Options
 * are of operation "visibility"; NULL = defaults. The comparer's method "distance" has the same rows, and does all this
 * when its parameter "visibility" says stations.
 */
#ifndef JALON_VISIBILITY_H
#define JALON_VISIBILITY_H

#include <jalon/comparer.h>

JALON_BEGIN_C

/** Label of a point that a scanner could have seen; the others are JALON_HIDDEN, _OUT_OF_RANGE, _OUT_OF_FIELD. */
enum { JALON_VISIBLE = 0 };

/** How a hidden point came to what is known of it: column "recovered" (uint8) of a comparison. */
enum {
  JALON_NOT_RECOVERED = 0,
  JALON_RECOVERED_VERTICAL = 1, /**< vertical: "height" has its sign, "distance" its size */
  JALON_RECOVERED_OCCLUDER = 2, /**< hidden = occluders: fits what hides it; see "shape_residual" */
  JALON_PROBABLY_UNCHANGED = 3, /**< no distance, but the same before and after */
  JALON_CHANGED_MEANWHILE = 4   /**< no distance, and not the same before and after: when is open */
};

/**
 * Gives the cloud the field "visibility" (uint8), as the stations of the reference see its points: JALON_VISIBLE when
 * the range is at most depth_margin_factor times that of the surface seen there plus depth_margin_m, else
 * JALON_HIDDEN; JALON_OUT_OF_RANGE from max_range_m on; JALON_OUT_OF_FIELD outside the map. Of several stations the
 * best label counts. With second_centre_m both optical centres of a triangulation scanner must see a point. An empty
 * reference sees nothing. O(points of both + cells), parallel.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_compute_visibility(jalon_cloud* cloud,
                                                                  const jalon_cloud* reference,
                                                                  const jalon_params* options,
                                                                  jalon_task* task);

/**
 * The depth map of a station of the reference: rows x columns cells, row by row upward from the
 * lowest, each clockwise. rows and columns may be NULL; a station without points has none of
 * either.
 *     column      type     unit  meaning
 *     range       float32  m     of the surface; NaN for an empty cell
 *     fill        uint8    -     0 empty, 1 measured, 2 filled from its neighbours
 *     points      uint32   -     how many fell in it
 *     nearest     uint32   -     index of the nearest of them in the cloud; UINT32_MAX without
 *     horizontal  float64  rad   of the cell's centre, clockwise from +Y
 *     vertical    float64  rad   of the cell's centre, from the horizon
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_depth_map(const jalon_cloud* reference,
                                                         uint64_t station,
                                                         const jalon_params* options,
                                                         jalon_task* task, jalon_fields** out,
                                                         uint64_t* rows, uint64_t* columns);

/**
 * The same as a PNG picture as the scanner sees the scene, one pixel a cell: grey 255 for the nearest range down to 30
 * for the farthest, even in the logarithm of the range; dark blue for empty cells. The text chunk "Description" of the
 * file tells both ranges. A path that ends in ".tif" or ".tiff" gets the ranges themselves, as a TIFF of float32 in
 * metres with -9999 as GDAL's no-data value; ModelPixelScale and ModelTiepoint place its pixels in degrees, clockwise
 * from +Y and up from the horizon, and no coordinate system is named. JALON_ERROR_INSUFFICIENT_DATA for a station
 * without points.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_write_depth_map(const jalon_cloud* reference,
                                                               uint64_t station, const char* path,
                                                               const jalon_params* options,
                                                               jalon_task* task);

/**
 * A third epoch for what was hidden: of two comparisons of the same points, "hidden" with epoch t as the reference and
 * "across" with the epoch beyond it, a new one like "hidden" whose column "recovered" says of each point that is
 * JALON_HIDDEN at t and compared across: JALON_PROBABLY_UNCHANGED when its distance across is at most tolerance_m
 * (m), else JALON_CHANGED_MEANWHILE. Distances and status stay. With the points of t - 1 compared with t and t + 1 (or
 * of t + 1 with t and t - 1) it tells what most probably did not move behind the obstacles of t.
 * JALON_ERROR_INVALID_ARGUMENT when the two are of different points. O(n).
 */
JALON_API JALON_CHECK jalon_status jalon_comparison_third_epoch(const jalon_comparison* hidden,
                                                                const jalon_comparison* across,
                                                                double tolerance_m,
                                                                jalon_task* task,
                                                                jalon_comparison** out);

JALON_END_C

#endif
