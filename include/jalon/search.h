/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file search.h
 * Neighbours and cells: the cloud's octree of sorted Morton codes (Girardeau-Montaut 2006, chapter 4).
 *
 * Answers are exact: they equal a brute-force search in double precision; the k nearest come
 * nearest first, ties by smaller index. Level 0 is the cube around the cloud, level 21 the deepest.
 * Codes interleave the cell numbers as x y z bits, x highest.
 */
#ifndef JALON_SEARCH_H
#define JALON_SEARCH_H

#include <jalon/cloud.h>

JALON_BEGIN_C

enum { JALON_OCTREE_MAX_LEVEL = 21, JALON_LEVEL_AUTOMATIC = -1 };

/** Stands in index arrays where fewer than k neighbours exist; its distance is infinity. */
#define JALON_NO_POINT UINT64_MAX

/**
 * The k nearest points of each query. Parallel.
 *
 * - queries: as xyz of jalon_cloud_create.
 * - level: JALON_LEVEL_AUTOMATIC for the adaptive search, or 1..21 for the constant-level search of
 *   section 4.4; the answer is the same.
 * - indices: count * k.
 * - squared_distances: count * k, or NULL.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_knn(const jalon_cloud* cloud, const void* queries,
                                                   int32_t type, uint64_t count,
                                                   uint64_t stride_bytes, uint32_t k, int32_t level,
                                                   jalon_task* task, uint64_t* indices,
                                                   double* squared_distances);
/**
 * The k nearest points of every point of the cloud, itself included, in the cloud's order: the fast batch form, k <=
 * 256. indices: 32 bits, UINT32_MAX where there are fewer; after a failure the arrays may be partly written. Which
 * neighbours they are, and their order, is exact. squared_distances are in single precision, of points rounded down to
 * the octree's grid: a distance is within sqrt(3) edge / 2^31 (1e-7 m for a cube of 128 m) and 1e-6 of itself from the
 * exact one, which jalon_cloud_knn gives.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_knn_all(const jalon_cloud* cloud, uint32_t k,
                                                       jalon_task* task, uint32_t* indices,
                                                       float* squared_distances);
/**
 * The points within radius_m (closed ball) of each query.
 *
 * ranges, count + 1 rows:
 *     column  type    unit  meaning
 *     first   uint64  -     where the neighbours of each query begin, and at last how many there
 *                           are
 *
 * neighbours, one row a pair of query and point, those of a query by ascending index:
 *     column    type     unit  meaning
 *     index     uint64   -     of the point in the cloud
 *     distance  float64  m     from the query
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_radius_search(const jalon_cloud* cloud,
                                                             const void* queries, int32_t type,
                                                             uint64_t count, uint64_t stride_bytes,
                                                             double radius_m, jalon_task* task,
                                                             jalon_fields** ranges,
                                                             jalon_fields** neighbours);
/** The cube of the octree: lowest corner and edge length (m). Each output may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_cloud_octree_cube(const jalon_cloud* cloud,
                                                           jalon_task* task, jalon_vec3* origin,
                                                           double* edge_m);
/**
 * Occupied cells of a level 0..21, in code order.
 *     column  type         unit  meaning
 *     code    uint64       -     Morton code, 3 bits a level
 *     first   uint64       -     its first point in code order
 *     count   uint64       -     points of the cell
 *     centre  float64 x 3  m     of the cell
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_cells(const jalon_cloud* cloud, int32_t level,
                                                     jalon_task* task, jalon_fields** out);
/**
 * Indices of the points in code order: cell c of any level holds the points order[first] ...
 * order[first + count - 1].
 *     column  type    unit  meaning
 *     order   uint64  -     index of the point
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_order(const jalon_cloud* cloud, jalon_task* task,
                                                     jalon_fields** out);
/**
 * The occupied cells at Chebyshev distance 1..reach of a cell, ascending.
 *     column  type    unit  meaning
 *     code    uint64  -     Morton code of the cell
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_cell_neighbours(const jalon_cloud* cloud,
                                                               int32_t level, uint64_t code,
                                                               uint32_t reach, jalon_task* task,
                                                               jalon_fields** out);
/**
 * Level at which the constant-level search of k neighbours in cloud for all points of compared is expected to be
 * fastest (formula 4.2 of the source). The two should share their cube.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_best_level(const jalon_cloud* cloud,
                                                          const jalon_cloud* compared, uint32_t k,
                                                          jalon_task* task, int32_t* out);
/** Gives several clouds octrees on one common cube, so that equal codes mean the same place. Rebuilds those that
 * differ. */
JALON_API JALON_CHECK jalon_status jalon_cloud_share_octree(jalon_cloud* const* clouds,
                                                            uint64_t count, jalon_task* task);

JALON_END_C

#endif
