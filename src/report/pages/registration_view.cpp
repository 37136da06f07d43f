// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/registration_view.h"

#include "report/viewer/channels.h"

namespace jalon {

ViewScene registration_scene(const Registration& registration, const CloudPtr& reference,
                             const CloudPtr& moving) {
  // Blue and orange are told apart with red-green blindness too, and in print.
  constexpr Rgb kReference{0x2c, 0x72, 0x8e}, kMoved{0xd9, 0x6a, 0x10}, kAsItCame{0xb8, 0xa0, 0x8c};
  ViewScene scene;
  scene.clouds.push_back({"reference", reference, {}, kReference, false, {}});
  scene.clouds.push_back({"moved", moving, registration.pose, kMoved, false, {}});
  scene.clouds.push_back({"as it came", moving, {}, kAsItCame, true, {}});
  for (ViewCloud& view : scene.clouds) add_field_channels(view);
  scene.focus = box_without_strays(*reference, {});
  return scene;
}

}  // namespace jalon
