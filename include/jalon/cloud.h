/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file cloud.h
 * Point clouds: making them, their fields, stations and CRS, and what surveyors do to them.
 *
 * A cloud is points + named per-point fields + scan stations (pose, range of points) + CRS text. Its points never
 * change; coordinates are kept as the caller's doubles, untouched, in metres. Functions that select, append or
 * transform return a new cloud that shares what it can. Fields are added or replaced whole.
 *
 * Threads: functions on a const cloud may run on many threads at once; the others need the cloud for themselves.
 * Distinct clouds are free of each other even when they share storage. The index (an octree) is built once, when first
 * needed or by jalon_cloud_prepare, and is safe to query from many threads.
 *
 * Non-finite coordinates are refused with the index of the first one, or dropped with JALON_CLOUD_DROP_INVALID.
 */
#ifndef JALON_CLOUD_H
#define JALON_CLOUD_H

#include <jalon/fields.h>
#include <jalon/params.h>
#include <jalon/task.h>

JALON_BEGIN_C

typedef struct jalon_cloud jalon_cloud;
typedef struct jalon_cloud_builder jalon_cloud_builder;

enum { JALON_CLOUD_DROP_INVALID = 1 };

/* ---- making ---- */

/**
 * From an array of points. Everything is copied. O(n).
 *
 * - xyz: the x of the first point; y and z follow it as elements of the same type.
 * - type: any JALON_ element type.
 * - count: points; 0 gives an empty cloud.
 * - stride_bytes: leads to the next point; 0 = packed.
 * - flags: 0 or JALON_CLOUD_DROP_INVALID.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_create(const void* xyz, int32_t type, uint64_t count,
                                                      uint64_t stride_bytes, uint32_t flags,
                                                      jalon_cloud** out);
/** The same from three separate columns; stride_bytes (0 = packed) applies to each. */
JALON_API JALON_CHECK jalon_status jalon_cloud_create_columns(const void* x, const void* y,
                                                              const void* z, int32_t type,
                                                              uint64_t count, uint64_t stride_bytes,
                                                              uint32_t flags, jalon_cloud** out);
/**
 * A cloud of its own with the same points, fields, stations and CRS: what is set on one of them later is not set on the
 * other. Shares the storage and the index: O(fields).
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_copy(const jalon_cloud* cloud, jalon_cloud** out);
JALON_API jalon_cloud* jalon_cloud_retain(jalon_cloud* cloud);
JALON_API void jalon_cloud_release(jalon_cloud* cloud);

/**
 * A builder takes a cloud in pieces: declare the fields, open stations, append points and the fields' values in any
 * block sizes, then seal. flags as in jalon_cloud_create; with JALON_CLOUD_DROP_INVALID the field values of dropped
 * points go too.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_builder_create(uint32_t flags,
                                                              jalon_cloud_builder** out);
JALON_API jalon_cloud_builder* jalon_cloud_builder_retain(jalon_cloud_builder* builder);
JALON_API void jalon_cloud_builder_release(jalon_cloud_builder* builder);
/** CRS text of the cloud to be (WKT, a URN, ...). */
JALON_API JALON_CHECK jalon_status jalon_cloud_builder_set_crs(jalon_cloud_builder* builder,
                                                               const char* crs);
/** A field of the cloud to be: components elements of this type a point. unit and meaning may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_cloud_builder_declare_field(jalon_cloud_builder* builder,
                                                                     const char* name, int32_t type,
                                                                     uint32_t components,
                                                                     const char* unit,
                                                                     const char* meaning);
/**
 * Points appended from now on belong to this station. pose maps scanner to world coordinates and must be a rigid motion
 * (a rotation within 1e-6, no scale, no mirror); NULL = unknown.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_builder_begin_station(jalon_cloud_builder* builder,
                                                                     const char* name,
                                                                     const jalon_transform* pose);
/** The next count points, laid out as in jalon_cloud_create. */
JALON_API JALON_CHECK jalon_status jalon_cloud_builder_append_points(jalon_cloud_builder* builder,
                                                                     const void* xyz, int32_t type,
                                                                     uint64_t count,
                                                                     uint64_t stride_bytes);
/** Appends count items to a declared field, converting from type. */
JALON_API JALON_CHECK jalon_status jalon_cloud_builder_append_field(jalon_cloud_builder* builder,
                                                                    const char* name,
                                                                    const void* data, int32_t type,
                                                                    uint64_t count,
                                                                    uint64_t stride_bytes);
/** Makes the cloud and empties the builder. Each field must have one item a point. */
JALON_API JALON_CHECK jalon_status jalon_cloud_builder_seal(jalon_cloud_builder* builder,
                                                            jalon_cloud** out);

/* ---- looking ---- */

/** Number of points. */
JALON_API JALON_CHECK jalon_status jalon_cloud_count(const jalon_cloud* cloud, uint64_t* out);
/** Coordinates, (n, 3) float64, no copy; lives as long as any cloud that shares them. */
JALON_API JALON_CHECK jalon_status jalon_cloud_points(const jalon_cloud* cloud,
                                                      jalon_array_view* out);
/** Snapshot of the fields. The caller releases it. */
JALON_API JALON_CHECK jalon_status jalon_cloud_fields(const jalon_cloud* cloud, jalon_fields** out);
/** Smallest box around the points; JALON_ERROR_INSUFFICIENT_DATA for an empty cloud. O(n). */
JALON_API JALON_CHECK jalon_status jalon_cloud_bounds(const jalon_cloud* cloud, jalon_box* out);
/** CRS text (WKT, a URN, ...), "" when unknown. Lives until the CRS is set again or the cloud is released. */
JALON_API JALON_CHECK jalon_status jalon_cloud_crs(const jalon_cloud* cloud, const char** out);
JALON_API JALON_CHECK jalon_status jalon_cloud_set_crs(jalon_cloud* cloud, const char* crs);
/** Number of stations. */
JALON_API JALON_CHECK jalon_status jalon_cloud_station_count(const jalon_cloud* cloud,
                                                             uint64_t* out);
/**
 * Station i: its name, whether its pose is known (1 or 0), the pose, and its points [first, first + count). Each output
 * may be NULL.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_station(const jalon_cloud* cloud, uint64_t i,
                                                       const char** name, int32_t* has_pose,
                                                       jalon_transform* pose, uint64_t* first,
                                                       uint64_t* count);
/**
 * Declares one station with this pose for all points of the cloud, replacing what it had. pose: a rigid motion as of
 * jalon_cloud_builder_begin_station, or NULL.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_set_station(jalon_cloud* cloud, const char* name,
                                                           const jalon_transform* pose);

/** Adds or replaces a field; count must be the number of points. Everything is copied. unit and meaning may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_cloud_set_field(jalon_cloud* cloud, const char* name,
                                                         const void* data, int32_t type,
                                                         uint32_t components, uint64_t count,
                                                         uint64_t stride_bytes, const char* unit,
                                                         const char* meaning);
/** JALON_ERROR_NOT_FOUND where there is none of the name. Views of it stay valid. */
JALON_API JALON_CHECK jalon_status jalon_cloud_remove_field(jalon_cloud* cloud, const char* name);
/** Builds the index ahead. Parallel, O(n). */
JALON_API JALON_CHECK jalon_status jalon_cloud_prepare(const jalon_cloud* cloud, jalon_task* task);
/** Gives back the memory of the index, about 20 bytes a point, of this cloud and its copies: for one that is kept while
 * other work is done. The next call that needs the index builds it again. Any thread; calls that use it go on. O(1). */
JALON_API JALON_CHECK jalon_status jalon_cloud_drop_index(const jalon_cloud* cloud);

/* ---- new clouds from old ones ---- */

/** The points of these indices, in this order, with their fields. Indices may repeat. */
JALON_API JALON_CHECK jalon_status jalon_cloud_select(const jalon_cloud* cloud,
                                                      const uint64_t* indices, uint64_t count,
                                                      jalon_task* task, jalon_cloud** out);
/** Points whose scalar field equals value, and the others. Each output may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_cloud_split(const jalon_cloud* cloud, const char* field,
                                                     double value, jalon_task* task,
                                                     jalon_cloud** equal, jalon_cloud** others);
/** a then b. Fields of one only are filled with 0 (integers) or NaN; the CRS must agree or be unknown in one. */
JALON_API JALON_CHECK jalon_status jalon_cloud_append(const jalon_cloud* a, const jalon_cloud* b,
                                                      jalon_task* task, jalon_cloud** out);
/**
 * Points, station poses and the field "normal" moved by the transform, which must be invertible. Where it stretches or
 * mirrors, a station goes where it is mapped and its frame stays a right-handed one: its z axis along the mapped one,
 * its x axis as near the mapped one as is square to that.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_transform(const jalon_cloud* cloud,
                                                         const jalon_transform* transform,
                                                         jalon_task* task, jalon_cloud** out);
/** Points inside the closed box given in its own frame (T_box_world maps world to box; NULL = world). outside may be
 * NULL. */
JALON_API JALON_CHECK jalon_status jalon_cloud_crop_box(const jalon_cloud* cloud,
                                                        const jalon_box* box,
                                                        const jalon_transform* T_box_world,
                                                        jalon_task* task, jalon_cloud** inside,
                                                        jalon_cloud** outside);
/**
 * Points inside a prism: a simple polygon swept along w. Even-odd rule; the border counts as
 * inside.
 *
 * - polygon_uv: count corners, u and v of each.
 * - w_min, w_max: where the prism begins and ends.
 * - T_prism_world: maps world coordinates to u, v, w; NULL: u, v, w = x, y, z.
 * - inside, outside: each may be NULL.
 */
JALON_API JALON_CHECK jalon_status
jalon_cloud_crop_polygon(const jalon_cloud* cloud, const double* polygon_uv, uint64_t count,
                         double w_min, double w_max, const jalon_transform* T_prism_world,
                         jalon_task* task, jalon_cloud** inside, jalon_cloud** outside);
/** Points inside the closed cylinder from foot to top with this radius. */
JALON_API JALON_CHECK jalon_status jalon_cloud_crop_cylinder(const jalon_cloud* cloud,
                                                             const jalon_vec3* foot,
                                                             const jalon_vec3* top, double radius_m,
                                                             jalon_task* task, jalon_cloud** inside,
                                                             jalon_cloud** outside);

/* ---- per-point properties: they add fields; options may be NULL for the defaults ---- */

/**
 * Normals of the points. Operation "normals": "method" pca | quadric | triangulation, "k" or
 * "radius_m", "orientation" none | station | point | centroid. Points without a normal get NaN.
 * Sources: Hoppe et al. 1992 (pca); Girardeau-Montaut 2006, annex A.2 (triangulation, quadric).
 *
 * Fields:
 *     column     type         unit  meaning
 *     normal     float32 x 3  -     unit length
 *     curvature  float32      -     surface variation; of method pca with "curvature" = true
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_compute_normals(jalon_cloud* cloud,
                                                               const jalon_params* options,
                                                               jalon_task* task);
/** Turns all normals round. */
JALON_API JALON_CHECK jalon_status jalon_cloud_invert_normals(jalon_cloud* cloud, jalon_task* task);
/**
 * Those of these fields that the text list "which" of operation "features" names:
 *     column              type     unit   meaning
 *     density             float32  1/m^2  points per square metre of surface
 *     roughness           float32  m      distance to the least-squares plane of the neighbours
 *     mean_curvature      float32  1/m    of the quadric through them, without its sign
 *     gaussian_curvature  float32  1/m^2  of the quadric through them
 *     surface_variation   float32  1      least eigenvalue of the neighbours' covariance over their
 *                                         sum
 *     linearity           float32  1      (s1 - s2) / s1; s: square roots of the eigenvalues, s1
 *                                         the largest (Demantke et al. 2011)
 *     planarity           float32  1      (s2 - s3) / s1
 *     sphericity          float32  1      s3 / s1
 *     verticality         float32  1      1 - |z component of the normal|
 *     surface_class       uint8    -      1 = surface; 2 = edge, where one surface ends; 3 = boundary,
 *                                         where several meet; 0 = the neighbours span no plane
 *                                         (Belton & Lichti 2006, their noise from the cloud)
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_compute_features(jalon_cloud* cloud,
                                                                const jalon_params* options,
                                                                jalon_task* task);
/**
 * Field "component" (uint32, 1 = largest, 0 = too small or left out). Operation "components": cell_m or level,
 * connectivity 6 | 18 | 26, min_points; field and value connect only the points with that value, such as those that a
 * filter marked "changed" (Girardeau-Montaut 2006, 3.2.4). *out = number of components.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_compute_components(jalon_cloud* cloud,
                                                                  const jalon_params* options,
                                                                  jalon_task* task, uint64_t* out);

/* ---- statistics of the whole cloud ---- */

/** Centroid and 3 x 3 covariance (divided by n). Each output may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_cloud_covariance(const jalon_cloud* cloud,
                                                          jalon_task* task, jalon_vec3* centroid,
                                                          double covariance[9]);
/** (1/n) sum of u^a v^b w^c with u, v, w centred on the centroid (centred != 0) or as they are. a, b, c <= 8. */
JALON_API JALON_CHECK jalon_status jalon_cloud_moment(const jalon_cloud* cloud, uint32_t a,
                                                      uint32_t b, uint32_t c, int32_t centred,
                                                      jalon_task* task, double* out);

/* ---- cleaning and sampling; report may be NULL ---- */

/**
 * Keeps the first of the points whose three coordinates agree after rounding to tolerance_m (0.0001 m is usual), with
 * all its fields. Boulaassal 2010, eq. 3.2 in its intended form. O(n log n).
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_remove_duplicates(const jalon_cloud* cloud,
                                                                 double tolerance_m,
                                                                 jalon_task* task,
                                                                 jalon_cloud** out,
                                                                 jalon_reduction* report);
/** Operation "outliers": method statistical (k, sigmas) | radius (radius_m, neighbours). */
JALON_API JALON_CHECK jalon_status jalon_cloud_remove_outliers(const jalon_cloud* cloud,
                                                               const jalon_params* options,
                                                               jalon_task* task, jalon_cloud** out,
                                                               jalon_reduction* report);
/** Operation "subsample": method voxel | minimum_distance | random | octree. Any cell size. */
JALON_API JALON_CHECK jalon_status jalon_cloud_subsample(const jalon_cloud* cloud,
                                                         const jalon_params* options,
                                                         jalon_task* task, jalon_cloud** out,
                                                         jalon_reduction* report);
/**
 * Splits a facade scan into points of interest (the largest vertical entity) and the rest (obstacles in front, ghosts
 * behind). Operation "interest". Boulaassal 2010, section 3.3. Each output may be NULL.
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_split_interest(const jalon_cloud* cloud,
                                                              const jalon_params* options,
                                                              jalon_task* task,
                                                              jalon_cloud** interest,
                                                              jalon_cloud** unwanted);

JALON_END_C

#endif
