// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "formats/ifc/step_file.h"
#include "model/model.h"

namespace jalon::ifc {

/// What all products of a file refer to.
struct Frame {
  Id axes = 0;  ///< those of the origin
  Id body = 0;  ///< the context of their shapes
  Id site = 0, site_placement = 0;
};

/// Units, contexts, project and site. Coordinates count from the origin: the map conversion adds it where the CRS of
/// the model has an EPSG code in metres, else the place of the site.
Frame add_frame(StepFile& file, const Model& model, const Vec3& origin);

/// What all rooted objects begin with: an identifier hashed from the key, no history, the name, no description.
Values root(const std::string& key, const std::string& name);
/// That a whole consists of parts; nothing where there are none.
void aggregate(StepFile& file, const std::string& key, Id whole, const std::vector<Id>& parts);

}  // namespace jalon::ifc
