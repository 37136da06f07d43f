/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file model.h
 * Vector models: vertices, faces with holes, triangle meshes, in a tree of parts. Immutable; readable by many threads.
 */
#ifndef JALON_MODEL_H
#define JALON_MODEL_H

#include <jalon/fields.h>
#include <jalon/task.h>

JALON_BEGIN_C

typedef struct jalon_model jalon_model;

/**
 * A model that is one triangle mesh. vertices: as xyz of jalon_cloud_create; triangles: count_triangles x 3 vertex
 * indices, counted from 0, packed. face_ids: one number a triangle, or NULL (the triangle's index); the virtual scanner
 * hands them on to the points.
 */
JALON_API JALON_CHECK jalon_status jalon_model_create_mesh(const void* vertices, int32_t type,
                                               uint64_t count_vertices, uint64_t stride_bytes,
                                               const uint32_t* triangles, uint64_t count_triangles,
                                               const uint32_t* face_ids, jalon_model** out);
JALON_API jalon_model* jalon_model_retain(jalon_model* model);
JALON_API void jalon_model_release(jalon_model* model);

/** Column "xyz" (float64 x 3, m). */
JALON_API JALON_CHECK jalon_status jalon_model_vertices(const jalon_model* model, jalon_fields** out);
/**
 * One row a face: "part" (uint32), "first_ring", "ring_count" (uint64; the first ring is the outline, the others its
 * openings), "id" (uint32), "class" (uint8), "normal" (float64 x 3), "offset" (float64, m; normal . p = offset), "area"
 * (float64, m2, openings taken off), "sigma" (float64, m), "covariance" (float64 x 16 of normal and offset).
 */
JALON_API JALON_CHECK jalon_status jalon_model_faces(const jalon_model* model, jalon_fields** out);
/** One row a ring: "first", "count" (uint64) in the ring corners. */
JALON_API JALON_CHECK jalon_status jalon_model_rings(const jalon_model* model, jalon_fields** out);
/** One row a ring corner: "vertex" (uint32). Outlines run counter-clockwise seen against the normal, openings
 * clockwise. */
JALON_API JALON_CHECK jalon_status jalon_model_corners(const jalon_model* model, jalon_fields** out);
/** One row a triangle: "vertices" (uint32 x 3), "face" (uint32: the id given, or the face's id). */
JALON_API JALON_CHECK jalon_status jalon_model_triangles(const jalon_model* model, jalon_fields** out);
JALON_API JALON_CHECK jalon_status jalon_model_part_count(const jalon_model* model, uint64_t* out);
/** Part i: its name, its class ("facade", "wall", ...) and its parent (or UINT64_MAX). Each output may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_model_part(const jalon_model* model, uint64_t i, const char** name,
                                        const char** part_class, uint64_t* parent);

JALON_END_C

#endif
