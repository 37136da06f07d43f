// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/field.h"
#include "model/model.h"

namespace jalon::capi {

// The tables of a model, as jalon/model.h tells them.
FieldTable vertex_table(const Model& model);
FieldTable face_table(const Model& model);
FieldTable ring_table(const Model& model);
FieldTable corner_table(const Model& model);
FieldTable edge_table(const Model& model);
FieldTable solid_table(const Model& model);
FieldTable part_table(const Model& model);
FieldTable triangle_table(const Model& model);

}  // namespace jalon::capi
