/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file modeller.h
 * Modelling: a cloud and its segmentation in, a vector model out.
 *
 * A modeller holds parameters and no data; one thread at a time sets them, several may run it once set.
 */
#ifndef JALON_MODELLER_H
#define JALON_MODELLER_H

#include <jalon/model.h>
#include <jalon/segmenter.h>

JALON_BEGIN_C

typedef struct jalon_modeller jalon_modeller;

/** method: "outlines" (NULL = the same): one face with openings a plane, straight edges. */
JALON_API JALON_CHECK jalon_status jalon_modeller_create(const char* method, jalon_modeller** out);
JALON_API jalon_modeller* jalon_modeller_retain(jalon_modeller* modeller);
JALON_API void jalon_modeller_release(jalon_modeller* modeller);
/** The modeller's own parameter set: setting it changes the modeller. The caller releases it. */
JALON_API JALON_CHECK jalon_status jalon_modeller_params(jalon_modeller* modeller, jalon_params** out);
/** cloud must be the cloud that was segmented. A segmentation without segments gives a model without faces. */
JALON_API JALON_CHECK jalon_status jalon_modeller_run(const jalon_modeller* modeller, const jalon_cloud* cloud,
                                          const jalon_segmentation* segmentation, jalon_task* task,
                                          jalon_model** out);

JALON_END_C

#endif
