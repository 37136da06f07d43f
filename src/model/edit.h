// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "model/model.h"

namespace jalon {

/// The same model with another name and class of one part. Throws kInvalidArgument when there is no such part.
Model with_renamed_part(Model model, uint64_t part, std::string name, std::string part_class);

/// The model without a part that is a copy (Evidence::kCopied): the user's veto. What is below it and its faces go, the
/// hole it filled in its wall closes, solids lose it on all sides and stay closed; parts, faces, rings and vertices
/// behind it move up. Throws kInvalidArgument when there is no such part or it is no copy.
Model without_copy(const Model& model, uint64_t part);

/// Area of a ring of a face with this normal, arcs included: positive for outlines, negative for openings.
double ring_area(const Model& model, const Ring& ring, const Vec3& normal);

}  // namespace jalon
