// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/viewer/scene.h"

namespace jalon {

/// Channels of what clouds often have: field "intensity" in greys between the 2nd and 98th hundredth of its values,
/// fields red, green, blue as they are (of 16 bits the upper eight, where any is above 255).
void add_field_channels(ViewCloud& view);

/// The box that holds all but a hundredth of the points at each end of each axis: strays do not shrink the picture.
Box3 box_without_strays(const Cloud& cloud, const Transform& pose);

}  // namespace jalon
