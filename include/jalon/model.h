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
#include <jalon/params.h>
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

/** How two regions lie to each other (column "relation" of jalon_model_relations; Egenhofer & Herring 1990). */
enum {
  JALON_RELATION_DISJOINT = 1,   /**< nothing is shared */
  JALON_RELATION_MEET = 2,       /**< borders touch, interiors share nothing */
  JALON_RELATION_OVERLAP = 3,    /**< interiors share something, and each has some of its own */
  JALON_RELATION_COVERS = 4,     /**< the second lies in the first, their borders touch */
  JALON_RELATION_COVERED_BY = 5, /**< the first lies in the second, their borders touch */
  JALON_RELATION_CONTAINS = 6,   /**< the second lies in the first, away from its border */
  JALON_RELATION_INSIDE = 7,     /**< the first lies in the second, away from its border */
  JALON_RELATION_EQUAL = 8       /**< the same */
};

/** Bits of the column "direction" of jalon_model_relations, as somebody who looks at the facade says it. */
enum {
  JALON_DIRECTION_LEFT = 1,    /**< the second is left of the first */
  JALON_DIRECTION_RIGHT = 2,   /**< right of it */
  JALON_DIRECTION_BELOW = 4,   /**< below it */
  JALON_DIRECTION_ABOVE = 8,   /**< above it */
  JALON_DIRECTION_BEHIND = 16, /**< behind it, toward the inside of the building */
  JALON_DIRECTION_BEFORE = 32  /**< before it, out of the facade */
};

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
 *     column            type     unit  meaning
 *     parent            uint64   -     the part above, or UINT64_MAX
 *     width             float64  m     of its upright box in the plane of its wall
 *     height            float64  m     of the same box
 *     depth             float64  m     behind the plane of its wall, negative in front of it; NaN:
 *                                      not told
 *     copied_from       uint64   -     the part it repeats, or UINT64_MAX
 *     lod               uint8    -     level of detail (CityGML 3.0): 2 walls and roofs, 3 with
 *                                      openings; 0: not told
 *     evidence          uint8    -     JALON_EVIDENCE_...
 *     class_confidence  float64  -     of openings: probability that the class is right; of class
 *                                      "opening" that of the likeliest, too small to be said; NaN:
 *                                      not told
 */
JALON_API JALON_CHECK jalon_status jalon_model_parts(const jalon_model* model, jalon_fields** out);
/**
 * Relations between the elements of a model: topology by the 9-intersection, distance, direction (Boulaassal 2010,
 * 5.6.3.3; Egenhofer & Herring 1990). Operation "relations". One row a pair up to "max_distance_m" apart, ascending; a
 * pair stands once, and read backwards its matrix is transposed.
 *
 * "elements" says what is compared:
 * - parts (default): each with all that is below it, as regions in the plane of their facade, so that a wall contains
 *   its windows and covers its doors, and overlaps what stands before it and beyond it. Parts of one facade are
 *   compared with each other (of all the model where it has none). Those seen edge-on (the ground, reveals) have no
 *   area there: such a pair is compared as surfaces in space, and left out where one is a part of the other.
 * - faces: pairs in one plane as regions of it, others as surfaces, which share at most what lies on the line where
 *   their planes meet.
 * - solids: closed volumes.
 *
 *     column     type         unit  meaning
 *     first      uint32       -     row of jalon_model_parts, _faces or _solids
 *     second     uint32       -     another, behind it
 *     relation   uint8        -     JALON_RELATION_...
 *     matrix     int8 x 9     -     dimension of what border, interior and exterior of the first (rows)
 *                                   share with those of the second: -1 nothing, 0 points, 1 lines,
 *                                   2 surfaces, 3 volumes
 *     distance   float64      m     least distance in space; 0: they touch
 *     direction  uint8        -     bits: where the whole of the second lies beyond the whole of the
 *                                   first; 0: nowhere
 *     offset     float64 x 3  m     from the middle of the first to that of the second: to the right,
 *                                   up, out of the facade
 *
 * Points within "tolerance_m" of a border are on it. JALON_ERROR_INSUFFICIENT_DATA for a model without such elements.
 * O(n^2) boxes and the edges of near pairs.
 */
JALON_API JALON_CHECK jalon_status jalon_model_relations(const jalon_model* model,
                                                         const jalon_params* options,
                                                         jalon_task* task, jalon_fields** out);
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
