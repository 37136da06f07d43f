/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file changes.h
 * From distances to changes: connected regions of changed points with what they measure.
 */
#ifndef JALON_CHANGES_H
#define JALON_CHANGES_H

#include <jalon/comparer.h>

JALON_BEGIN_C

/**
 * The changed points of a comparison and their connected regions (Girardeau-Montaut 2006, 3.2.4). options: operation
 * "regions" (criterion automatic | threshold | significance | field; threshold_m; cell_m, connectivity, min_points).
 * JALON_ERROR_INVALID_ARGUMENT when the criterion needs a column that the comparison does not have. A comparison
 * without changes gives JALON_OK and a table without rows. O(n log n).
 *
 * out_points: one row a point of the comparison: "changed" (uint8), "region" (uint32; 0 = in none). out_regions: one
 * row a region, most points first: "region" (uint32), "points" (uint64), "area" (float64, m2: of the sampled surface,
 * the sum of the discs that the points stand for), "mean", "rms", "extreme" (float64, m: of the distances; the extreme
 * with its sign), "centroid", "box_min", "box_max" (float64 x 3, m). Each output may be NULL.
 */
JALON_API JALON_CHECK jalon_status jalon_comparison_regions(const jalon_comparison* comparison,
                                                const jalon_params* options, jalon_task* task,
                                                jalon_fields** out_points, jalon_fields** out_regions);

JALON_END_C

#endif
