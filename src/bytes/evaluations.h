// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bytes/byte_reader.h"
#include "bytes/byte_writer.h"
#include "fieldtools/noise_law.h"
#include "modelling/evaluation/model_evaluation.h"
#include "segment/evaluation/evaluation.h"

namespace jalon {

// Results that look at nothing else. What is written must live until the writer has sealed.

void write_evaluation(ByteWriter& writer, const Evaluation& evaluation);
Evaluation read_evaluation(ByteReader& reader);

void write_model_evaluation(ByteWriter& writer, const ModelEvaluation& evaluation);
ModelEvaluation read_model_evaluation(ByteReader& reader);

void write_noise_law(ByteWriter& writer, const NoiseLaw& law);
/// As JSON, which gives the same law back.
NoiseLaw read_noise_law(ByteReader& reader);

}  // namespace jalon
