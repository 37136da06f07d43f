/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file buildings.h
 * Building models as blocks, facades and strips: what the joint adjustment of a cloud and a model moves, each by
 * itself (Monnier 2014).
 */
#ifndef JALON_BUILDINGS_H
#define JALON_BUILDINGS_H

#include <jalon/model.h>
#include <jalon/params.h>

JALON_BEGIN_C

/**
 * The vertical faces of a building model as strips of constant width. O(n log n).
 *
 * - Facades: each upright face (within "tilt_rad") is one, its openings closed; in a model without faces the
 *   triangles that lie in one plane of a building (1 degree, 2 cm) and touch. Normals look out of the building: where
 *   the footprint shows that one looks inward it is turned.
 * - Buildings: the highest part of class "building" above a face; in a model without such parts, what hangs together
 *   by corners (1 mm).
 * - Blocks: buildings whose footprints come within "touch_m" of each other, and those that touch these, and so on;
 *   with "corners" = false they must run along each other.
 * - Strips: from the facade's left end, seen from outside, "width_m" wide; what is left at the right end is a strip
 *   from half a width on, else it is added to the last ("remainder" = keep), or all are equal (equal). From the
 *   lowest to the highest of the facade, or clipped to its outline, gables and all ("top" = clip).
 *
 * A model of strips, as an adjusted one read from CityJSON, keeps its blocks, facades and strips with their numbers and
 * places: of the options "others" alone counts. Its facades stand in the mean of their strips.
 *
 * model: parts block - building - facade - strip of these classes; a face a strip (several where clipping cuts it in
 * parts), whose id is its number; two triangles a rectangle. With "others" behind them the faces that are no facades,
 * as they are: parts of class roof below their building, of class ground where they are of none.
 *
 * strips, one row a strip:
 *     column    type         unit  meaning
 *     block     uint32       -     its number
 *     building  uint32       -     its number
 *     facade    uint32       -     its number
 *     part      uint32       -     row of jalon_model_parts of the model given back
 *     normal    float64 x 3  1     level, out of the building
 *     place     float64 x 3  m     lower left corner, seen from outside
 *     width     float64      m     along the facade
 *     height    float64      m     of the facade
 *     turned    uint8        -     1: the face looked inward
 *
 * options: operation "building_strips". model, strips: each may be NULL. JALON_ERROR_INSUFFICIENT_DATA for a model
 * without upright faces.
 */
JALON_API JALON_CHECK jalon_status jalon_model_building_strips(const jalon_model* buildings,
                                                               const jalon_params* options,
                                                               jalon_task* task,
                                                               jalon_model** model,
                                                               jalon_fields** strips);

/**
 * A model of strips with each block, facade and strip off its place by a draw: blocks in plan, facades and strips
 * along the facade's normal; independent, normal, centred. For tests of an adjustment, whose truth it is.
 *
 * - strips: of jalon_model_building_strips; JALON_ERROR_INVALID_ARGUMENT for another.
 * - options: operation "building_sigmas": "sigma_block_m", "sigma_facade_m", "sigma_strip_m", "seed".
 * - model, block_offsets, facade_offsets, strip_offsets: each may be NULL.
 *
 * block_offsets, one row a block:
 *     column  type         unit  meaning
 *     offset  float64 x 2  m     east and north
 *
 * facade_offsets, one row a facade:
 *     column  type     unit  meaning
 *     offset  float64  m     along its normal
 *
 * strip_offsets, one row a strip:
 *     column  type     unit  meaning
 *     offset  float64  m     along its facade's normal
 */
JALON_API JALON_CHECK jalon_status jalon_model_perturb_strips(
    const jalon_model* strips, const jalon_params* options, jalon_model** model,
    jalon_fields** block_offsets, jalon_fields** facade_offsets, jalon_fields** strip_offsets);

JALON_END_C

#endif
