// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "capi/support/handles.h"
#include "modelling/evaluation/model_evaluation.h"
#include "segment/evaluation/evaluation.h"

struct jalon_evaluation : jalon::capi::Counted {
  jalon::Evaluation evaluation;
};

struct jalon_model_evaluation : jalon::capi::Counted {
  jalon::ModelEvaluation evaluation;
};
