/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file model.h
 * Vector models: vertices, edges (straight and arcs), faces with holes, solids, triangle meshes, in a tree of parts.
 * Immutable; readable by many threads. Tables are snapshots that the caller releases.
 */
#ifndef JALON_MODEL_H
#define JALON_MODEL_H

#include <jalon/fields.h>
#include <jalon/task.h>

JALON_BEGIN_C

typedef struct jalon_model jalon_model;

/** How a part is known (column "evidence" of jalon_model_parts). */
#define JALON_EVIDENCE_NONE 0        /**< not told */
#define JALON_EVIDENCE_MEASURED 1    /**< points lie on it */
#define JALON_EVIDENCE_SEEN_BEHIND 2 /**< an opening: points seen through it, behind the wall */
#define JALON_EVIDENCE_REVEALED 3    /**< an opening: its reveals were measured */
#define JALON_EVIDENCE_SHAPE 4   /**< an opening by its shape alone: nothing was seen through it */
#define JALON_EVIDENCE_COPIED 5  /**< a copy of a repeated element where data are missing */
#define JALON_EVIDENCE_DERIVED 6 /**< follows from other parts: reveals, sides of extrusions */

/**
 * A model that is one triangle mesh.
 *
 * - vertices: as xyz of jalon_cloud_create.
 * - triangles: count_triangles x 3 vertex indices, counted from 0, packed.
 * - face_ids: one number a triangle, or NULL (the triangle's index); the virtual scanner hands them
 *   on to the points.
 */
JALON_API JALON_CHECK jalon_status
jalon_model_create_mesh(const void* vertices, int32_t type, uint64_t count_vertices,
                        uint64_t stride_bytes, const uint32_t* triangles, uint64_t count_triangles,
                        const uint32_t* face_ids, jalon_model** out);
JALON_API jalon_model* jalon_model_retain(jalon_model* model);
JALON_API void jalon_model_release(jalon_model* model);

/**
 * One row a vertex.
 *     column      type         unit  meaning
 *     xyz         float64 x 3  m     the vertex
 *     covariance  float64 x 9  m2    row-major; NaN where it is not known
 */
JALON_API JALON_CHECK jalon_status jalon_model_vertices(const jalon_model* model,
                                                        jalon_fields** out);
/**
 * One row a face.
 *     column      type          unit  meaning
 *     part        uint32        -     row of jalon_model_parts
 *     first_ring  uint64        -     row of jalon_model_rings: the outline; the rings behind it
 *                                     are the openings
 *     ring_count  uint64        -     outline and openings
 *     id          uint32        -     e.g. label of the segment
 *     class       uint8         -     JALON_ORIENTATION_... of its plane
 *     normal      float64 x 3   1     unit length
 *     offset      float64       m     normal . p = offset
 *     area        float64       m2    openings taken off
 *     sigma       float64       m     of the points from the plane
 *     covariance  float64 x 16  -     of normal and offset, row-major
 */
JALON_API JALON_CHECK jalon_status jalon_model_faces(const jalon_model* model, jalon_fields** out);
/**
 * One row a ring.
 *     column  type    unit  meaning
 *     first   uint64  -     row of jalon_model_corners
 *     count   uint64  -     corners of the ring
 *     part    uint32  -     the opening that fills this hole of its face, or UINT32_MAX
 */
JALON_API JALON_CHECK jalon_status jalon_model_rings(const jalon_model* model, jalon_fields** out);
/**
 * One row a ring corner. Outlines run counter-clockwise seen against the normal, openings
 * clockwise.
 *     column   type     unit  meaning
 *     vertex   uint32   -     row of jalon_model_vertices
 *     sagitta  float64  m     rise of the arc from this corner to the next of its ring over the
 *                             chord; 0 = straight; positive = the arc runs anticlockwise seen
 *                             against the normal; its DXF bulge is 2 sagitta / chord
 */
JALON_API JALON_CHECK jalon_status jalon_model_corners(const jalon_model* model,
                                                       jalon_fields** out);
/**
 * One row a triangle.
 *     column    type        unit  meaning
 *     vertices  uint32 x 3  -     rows of jalon_model_vertices
 *     face      uint32      -     the id given, or the face's id
 */
JALON_API JALON_CHECK jalon_status jalon_model_triangles(const jalon_model* model,
                                                         jalon_fields** out);
/**
 * One row a pair of vertices that rings join, ascending. O(n log n).
 *     column       type     unit  meaning
 *     from         uint32   -     vertex, from < to
 *     to           uint32   -     vertex
 *     sagitta      float64  m     as the first face sees it from "from" to "to"; 0 = straight
 *     first_face   uint32   -     row of a face that shares it
 *     second_face  uint32   -     row of another; UINT32_MAX: a border
 *     uses         uint32   -     ring edges that run along it
 */
JALON_API JALON_CHECK jalon_status jalon_model_edges(const jalon_model* model, jalon_fields** out);
/**
 * One row a solid, a volume that faces enclose.
 *     column      type    unit  meaning
 *     part        uint32  -     row of jalon_model_parts
 *     first_face  uint64  -     row of jalon_model_faces; normals point outward
 *     face_count  uint64  -     its faces
 */
JALON_API JALON_CHECK jalon_status jalon_model_solids(const jalon_model* model, jalon_fields** out);
/**
 * One row a part. Names and classes: jalon_model_part.
 *     column       type     unit  meaning
 *     parent       uint64   -     the part above, or UINT64_MAX
 *     width        float64  m     of its upright box in the plane of its wall
 *     height       float64  m     of the same box
 *     depth        float64  m     behind the plane of its wall, negative in front of it; NaN: not
 *                                 told
 *     copied_from  uint64   -     the part it repeats, or UINT64_MAX
 *     lod          uint8    -     level of detail (CityGML 3.0): 2 walls and roofs, 3 with
 *                                 openings; 0: not told
 *     evidence     uint8    -     JALON_EVIDENCE_...
 */
JALON_API JALON_CHECK jalon_status jalon_model_parts(const jalon_model* model, jalon_fields** out);
/** CRS text of the vertices (WKT, a URN ...), "" when unknown; that of the cloud it was made from. Lives as long as the
 * model. */
JALON_API JALON_CHECK jalon_status jalon_model_crs(const jalon_model* model, const char** out);
/** Number of parts. */
JALON_API JALON_CHECK jalon_status jalon_model_part_count(const jalon_model* model, uint64_t* out);
/** Part i: its name, its class ("facade", "wall", ...) and its parent (or UINT64_MAX). Each output may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_model_part(const jalon_model* model, uint64_t i,
                                                    const char** name, const char** part_class,
                                                    uint64_t* parent);

/**
 * The model with another name and class of part i, as a new handle; the old one is the undo. name, part_class: UTF-8,
 * NULL = as it is. Costs a copy of the model.
 */
JALON_API JALON_CHECK jalon_status jalon_model_rename_part(const jalon_model* model, uint64_t i,
                                                           const char* name, const char* part_class,
                                                           jalon_model** out);
/**
 * The model without part i, a copy of a repeated element (JALON_EVIDENCE_COPIED): the user's veto, as a new handle.
 * What is below the part and its faces go, the hole it filled in its wall closes; parts, faces, rings and vertices
 * behind it move up. Any other part is JALON_ERROR_INVALID_ARGUMENT. O(size).
 */
JALON_API JALON_CHECK jalon_status jalon_model_remove_copy(const jalon_model* model, uint64_t i,
                                                           jalon_model** out);

JALON_END_C

#endif
