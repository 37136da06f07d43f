/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file scanner.h
 * The virtual scanner: a model and stations in, a cloud with ground truth out; and ready-made scenes.
 */
#ifndef JALON_SCANNER_H
#define JALON_SCANNER_H

#include <jalon/cloud.h>
#include <jalon/model.h>

JALON_BEGIN_C

typedef struct jalon_scanner jalon_scanner;

/** method: "static" (NULL = the same): a tripod scanner turning about its vertical axis. */
JALON_API JALON_CHECK jalon_status jalon_scanner_create(const char* method, jalon_scanner** out);
JALON_API jalon_scanner* jalon_scanner_retain(jalon_scanner* scanner);
JALON_API void jalon_scanner_release(jalon_scanner* scanner);
/** The scanner's own parameter set: angular steps, field of view, noise, dropout, outliers, seed, offset. */
JALON_API JALON_CHECK jalon_status jalon_scanner_params(jalon_scanner* scanner, jalon_params** out);
/** Adds a station; pose maps scanner to world coordinates and must be a rigid motion. name may be NULL. */
JALON_API JALON_CHECK jalon_status jalon_scanner_add_station(jalon_scanner* scanner, const char* name,
                                                 const jalon_transform* pose);
/**
 * Scans the model from all stations. Without a station, tripods are placed 1.7 m above the model's lowest point: two in
 * front of a facade at 0.6 x its width, two on the long axis of a street or room, four around a building, by the way its
 * upright faces look. Fields of the cloud: "face" (uint32: the id of the face hit; 0xffffffff for an outlier), "true_xyz"
 * (float64 x 3, m: the point without noise), "range" (float32, m, without noise) and, if the parameter says so,
 * "incidence_angle" (float32, rad). The cloud has one station with its pose for each station of the scanner. Same seed,
 * same bits, whatever the threads.
 */
JALON_API JALON_CHECK jalon_status jalon_scanner_run(const jalon_scanner* scanner, const jalon_model* model,
                                         jalon_task* task, jalon_cloud** out);

/**
 * A ready-made scene. Operation "scene": name facade (22 x 10 m, doors, windows with reveals, cornice, ground) |
 * street (60 m, six facades, boxes, columns) | room | box | surrounds | strips, and sizes; see the parameter table.
 * options may be NULL for the defaults. The model carries the true planes as faces with their openings in a tree of
 * parts, and the triangles that are scanned.
 */
JALON_API JALON_CHECK jalon_status jalon_scene_create(const jalon_params* options, jalon_task* task,
                                          jalon_model** out);

JALON_END_C

#endif
