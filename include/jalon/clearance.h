/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file clearance.h
 * Clearance: how near a model comes to a cloud or to another model, where they interfere and how deep; and a gauge
 * swept along a trajectory, with every place where it touches something or comes closer than a margin.
 *
 * Clearances are signed, in metres: positive apart, negative the depth inside. They are right to 1e-6 m. Options are of
 * operation "clearance"; NULL = defaults. Both inputs must have the same CRS where both tell one
 * (JALON_ERROR_INVALID_ARGUMENT). Points, faces and triangles are rows of the tables of their cloud or model;
 * UINT64_MAX stands where there is none.
 */
#ifndef JALON_CLEARANCE_H
#define JALON_CLEARANCE_H

#include <jalon/cloud.h>
#include <jalon/model.h>

JALON_BEGIN_C

/** Stands for all parts of a model. */
#define JALON_WHOLE_MODEL UINT64_MAX

/**
 * How near a model, or one of its parts with all below it, comes to a cloud. A surface is closed,
 * and has an inside, when every side of a triangle is shared with one other that runs along it the
 * other way. The depth of a point is its distance from the surface. JALON_ERROR_INSUFFICIENT_DATA
 * for an empty cloud or a part without a surface. O((points near) log (triangles)). Parallel.
 *
 * - part: its row, or JALON_WHOLE_MODEL.
 * - options: operation "clearance".
 * - summary, near_points: each may be NULL.
 *
 * summary, one row, of the nearest point, or of the deepest inside; near_points, by index, the
 * points within "margin_m" and all inside, with the same columns up to "foot":
 *     column      type         unit  meaning
 *     point       uint64       -     point of the cloud
 *     clearance   float64      m     from the surface; negative inside
 *     part        uint64       -     of the nearest surface
 *     face        uint64       -     of the nearest surface, or UINT64_MAX
 *     triangle    uint64       -     of the nearest surface, or UINT64_MAX
 *     xyz         float64 x 3  m     the point
 *     foot        float64 x 3  m     nearest point of the surface
 *     depth       float64      m     how deep the deepest point lies inside; 0 where none is; NaN
 *                                    unless closed
 *     interferes  uint8        -     1: a point touches the surface or lies inside
 *     closed      uint8        -     1: the surface encloses a volume
 *     near        uint64       -     rows of near_points
 *     inside      uint64       -     points inside
 */
JALON_API JALON_CHECK jalon_status jalon_model_clearance(const jalon_model* model, uint64_t part,
                                                         const jalon_cloud* cloud,
                                                         const jalon_params* options,
                                                         jalon_task* task, jalon_fields** summary,
                                                         jalon_fields** near_points);
/**
 * The same of two models or parts of them. JALON_ERROR_UNSUPPORTED in a library built without FCL.
 *
 * - part, other_part: their rows, or JALON_WHOLE_MODEL.
 * - options: operation "clearance".
 * - summary, near_faces: each may be NULL.
 *
 * summary, one row, of the nearest pair; near_faces, each triangle of the model within "margin_m"
 * of the other, once, with its nearest and the same columns up to "foot":
 *     column          type         unit  meaning
 *     clearance       float64      m     between the surfaces; negative the depth inside
 *     part            uint64       -     of the nearest triangle of the model
 *     face            uint64       -     its row, or UINT64_MAX
 *     triangle        uint64       -     its row, or UINT64_MAX
 *     other_part      uint64       -     of the nearest triangle of the other
 *     other_face      uint64       -     its row, or UINT64_MAX
 *     other_triangle  uint64       -     its row, or UINT64_MAX
 *     xyz             float64 x 3  m     nearest point of the other
 *     foot            float64 x 3  m     nearest point of the model
 *     depth           float64      m     of the deepest point of either inside the other; NaN:
 *                                        neither is closed
 *     interferes      uint8        -     1: they meet, or one lies in the other
 *     closed          uint8        -     1: the model's surface encloses a volume
 *     near            uint64       -     rows of near_faces
 *     other_closed    uint8        -     1: the other's surface encloses a volume
 *
 * Where they interfere, depth is exact in a convex surface, else at most "depth_tolerance_m" too
 * small; clearance is its negative, and xyz and foot are the deepest point and its nearest. Where
 * neither is closed, depth is NaN and the clearance 0.
 */
JALON_API JALON_CHECK jalon_status
jalon_model_clearance_to_model(const jalon_model* model, uint64_t part, const jalon_model* other,
                               uint64_t other_part, const jalon_params* options, jalon_task* task,
                               jalon_fields** summary, jalon_fields** near_faces);

/** Kinds of gauge pieces. */
enum {
  JALON_GAUGE_BOX = 1,      /**< size: its edges along x, y, z */
  JALON_GAUGE_SPHERE = 2,   /**< size.x: its radius */
  JALON_GAUGE_CYLINDER = 3, /**< size.x: its radius, size.z: its length, along z */
  JALON_GAUGE_HULL = 4      /**< the convex hull of hull points first ... first + count - 1 */
};

/** One solid convex piece of a gauge. Frozen. */
typedef struct jalon_gauge_piece {
  int32_t kind;
  int32_t reserved; /**< 0 */
  jalon_transform
      frame; /**< T_gauge_piece: rigid; the centre of boxes, spheres and cylinders is its origin */
  jalon_vec3 size; /**< m; not read for hulls */
  uint64_t first,
      count; /**< hulls: 4 to 4096 points in the gauge's frame moved by frame, not all in one plane */
} jalon_gauge_piece;

/**
 * A gauge (the union of 1 to 1000 pieces) along a trajectory through a cloud, a model or both.
 *
 * - hull_points: x, y, z packed, for pieces of kind JALON_GAUGE_HULL.
 * - poses: T_world_gauge, rigid within 1e-6; from each to the next the gauge's origin runs straight
 *   at an even speed and the gauge turns about one axis at an even rate by the smaller angle. One
 *   pose alone is a gauge that stands still.
 * - cloud, model: one of them may be NULL.
 * - options: operation "clearance".
 * - places, intervals: each may be NULL.
 *
 * places, in the order of the trajectory: each point and each triangle that touches the gauge or
 * comes within "margin_m" of it at any time, once, at its least clearance. intervals: one row from
 * each pose to the next, of its least clearance, with "near" besides:
 *     column     type         unit  meaning
 *     parameter  float64      1     number of the pose passed + share of the way to the next
 *     clearance  float64      m     from gauge to obstacle; negative inside; NaN where nothing
 *                                   comes within "reach_m" or the margin
 *     interval   uint32       -     from this pose to the next
 *     piece      uint32       -     of the gauge; UINT32_MAX = none
 *     kind       uint8        -     1 point, 2 face; 0 where nothing comes within reach or margin
 *     point      uint64       -     of the cloud, or UINT64_MAX
 *     part       uint64       -     of the model, or UINT64_MAX
 *     face       uint64       -     of the model, or UINT64_MAX
 *     triangle   uint64       -     of the model, or UINT64_MAX
 *     xyz        float64 x 3  m     the place, on the obstacle
 *     gauge_xyz  float64 x 3  m     nearest point of the piece's surface at that time
 *     near       uint64       -     intervals only: points and triangles within the margin
 *
 * Nothing between two poses is missed, however far apart they are: the signed distance of a convex
 * piece is convex, so its tangent planes bound it along the chord of an obstacle's path, and the
 * path leaves its chord by at most h^2 / 8 of its acceleration; times that the bounds do not rule
 * out are cut further. Clearance in a piece is that of the deepest point of the obstacle below that
 * piece's surface. O(poses (near points) log); parallel over the intervals.
 */
JALON_API JALON_CHECK jalon_status
jalon_gauge_sweep(const jalon_gauge_piece* pieces, uint64_t piece_count, const double* hull_points,
                  uint64_t hull_point_count, const jalon_transform* poses, uint64_t pose_count,
                  const jalon_cloud* cloud, const jalon_model* model, const jalon_params* options,
                  jalon_task* task, jalon_fields** places, jalon_fields** intervals);
/**
 * The same with a model as the gauge: each part with a surface of its own is one convex piece, in the order of the
 * parts; a mesh without parts is one piece. JALON_ERROR_INVALID_ARGUMENT for a part that is not convex,
 * JALON_ERROR_DEGENERATE for a flat one.
 */
JALON_API JALON_CHECK jalon_status jalon_gauge_sweep_model(
    const jalon_model* gauge, const jalon_transform* poses, uint64_t pose_count,
    const jalon_cloud* cloud, const jalon_model* model, const jalon_params* options,
    jalon_task* task, jalon_fields** places, jalon_fields** intervals);

JALON_END_C

#endif
