/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A wall of 6 x 4 m with a window of 1.2 x 1.5 m, segmented: what the modeller and report tests start from. */
#ifndef JALON_TEST_WALL_SCENE_H
#define JALON_TEST_WALL_SCENE_H

#include "support.h"

typedef struct wall_scene {
  jalon_cloud* cloud;
  jalon_segmentation* segmentation;
} wall_scene;

static inline wall_scene make_wall_scene(void) {
  enum { kColumns = 200, kRows = 133 };
  static double xyz[3 * kColumns * kRows];
  const double step = 0.03;
  uint64_t n = 0;
  for (int i = 0; i < kColumns; ++i)
    for (int j = 0; j < kRows; ++j) {
      const uint64_t k = (uint64_t)i * kRows + (uint64_t)j;
      const double x = step * (i + 0.5 * uniform(1, k)), z = step * (j + 0.5 * uniform(2, k));
      if (x > 2 && x < 3.2 && z > 1 && z < 2.5) continue;
      xyz[3 * n] = x;
      xyz[3 * n + 1] = 0.006 * (uniform(3, k) - 0.5);
      xyz[3 * n + 2] = z;
      ++n;
    }
  wall_scene scene = {NULL, NULL};
  jalon_segmenter* segmenter = NULL;
  MUST(jalon_cloud_create(xyz, JALON_FLOAT64, n, 0, 0, &scene.cloud));
  MUST(jalon_segmenter_create(NULL, &segmenter));
  MUST(jalon_segmenter_run(segmenter, scene.cloud, NULL, &scene.segmentation));
  jalon_segmenter_release(segmenter);
  return scene;
}

static inline jalon_model* model_of_scene(const wall_scene* scene) {
  jalon_modeller* modeller = NULL;
  jalon_model* model = NULL;
  MUST(jalon_modeller_create(NULL, &modeller));
  MUST(jalon_modeller_run(modeller, scene->cloud, scene->segmentation, NULL, &model));
  jalon_modeller_release(modeller);
  return model;
}

static inline void release_scene(wall_scene* scene) {
  jalon_segmentation_release(scene->segmentation);
  jalon_cloud_release(scene->cloud);
}

#endif
