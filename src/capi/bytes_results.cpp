// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Models and results as bytes.
#include "bytes/comparisons.h"
#include "bytes/evaluations.h"
#include "bytes/models.h"
#include "bytes/registrations.h"
#include "bytes/segmentations.h"
#include "capi/support/bytes_handle.h"
#include "capi/support/comparison_handles.h"
#include "capi/support/evaluation_handles.h"
#include "capi/support/model_handles.h"
#include "capi/support/noise_law_handle.h"
#include "capi/support/registration_handles.h"
#include "capi/support/worker_handles.h"

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_model_to_bytes(const jalon_model* model, jalon_task* task, jalon_bytes** out) {
  return guard([&] {
    require(model, "model");
    require(out, "out");
    *out = bytes_of(BytesKind::kModel, task, [&](ByteWriter& w) { write_model(w, *model->model); });
  });
}

jalon_status jalon_model_from_bytes(const uint8_t* bytes, uint64_t byte_count, jalon_task* task,
                                    jalon_model** out) {
  return guard([&] {
    require(out, "out");
    *out = read_bytes(bytes, byte_count, BytesKind::kModel, task, [](ByteReader& r, Task&) {
             return own(new_model(read_model(r)));
           }).release();
  });
}

jalon_status jalon_segmentation_to_bytes(const jalon_segmentation* segmentation, jalon_task* task,
                                         jalon_bytes** out) {
  return guard([&] {
    require(segmentation, "segmentation");
    require(out, "out");
    *out = bytes_of(BytesKind::kSegmentation, task,
                    [&](ByteWriter& w) { write_segmentation(w, *segmentation->segmentation); });
  });
}

jalon_status jalon_segmentation_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                           jalon_task* task, jalon_segmentation** out) {
  return guard([&] {
    require(out, "out");
    *out =
        read_bytes(bytes, byte_count, BytesKind::kSegmentation, task, [](ByteReader& r, Task& t) {
          auto handle = std::make_unique<jalon_segmentation>();
          handle->segmentation = std::make_shared<const Segmentation>(read_segmentation(r, t));
          return own(handle.release());
        }).release();
  });
}

jalon_status jalon_comparison_to_bytes(const jalon_comparison* comparison, jalon_task* task,
                                       jalon_bytes** out) {
  return guard([&] {
    require(comparison, "comparison");
    require(out, "out");
    *out = bytes_of(BytesKind::kComparison, task,
                    [&](ByteWriter& w) { write_comparison(w, *comparison->comparison); });
  });
}

jalon_status jalon_comparison_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                         jalon_task* task, jalon_comparison** out) {
  return guard([&] {
    require(out, "out");
    *out = read_bytes(bytes, byte_count, BytesKind::kComparison, task, [](ByteReader& r, Task& t) {
             auto handle = std::make_unique<jalon_comparison>();
             handle->comparison = std::make_shared<const Comparison>(read_comparison(r, t));
             return own(handle.release());
           }).release();
  });
}

jalon_status jalon_registration_to_bytes(const jalon_registration* registration, jalon_task* task,
                                         jalon_bytes** out) {
  return guard([&] {
    require(registration, "registration");
    require(out, "out");
    *out = bytes_of(BytesKind::kRegistration, task, [&](ByteWriter& w) {
      write_registration(w, *registration->registration);
      w.item(registration->crs);
    });
  });
}

jalon_status jalon_registration_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                           jalon_task* task, jalon_registration** out) {
  return guard([&] {
    require(out, "out");
    *out =
        read_bytes(bytes, byte_count, BytesKind::kRegistration, task, [](ByteReader& r, Task& t) {
          auto handle = std::make_unique<jalon_registration>();
          handle->registration = std::make_shared<const Registration>(read_registration(r, t));
          r.item(handle->crs);
          return own(handle.release());
        }).release();
  });
}

jalon_status jalon_evaluation_to_bytes(const jalon_evaluation* evaluation, jalon_bytes** out) {
  return guard([&] {
    require(evaluation, "evaluation");
    require(out, "out");
    *out = bytes_of(BytesKind::kEvaluation, nullptr,
                    [&](ByteWriter& w) { write_evaluation(w, evaluation->evaluation); });
  });
}

jalon_status jalon_evaluation_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                         jalon_evaluation** out) {
  return guard([&] {
    require(out, "out");
    *out = read_bytes(bytes, byte_count, BytesKind::kEvaluation, nullptr, [](ByteReader& r, Task&) {
             auto handle = std::make_unique<jalon_evaluation>();
             handle->evaluation = read_evaluation(r);
             return own(handle.release());
           }).release();
  });
}

jalon_status jalon_model_evaluation_to_bytes(const jalon_model_evaluation* evaluation,
                                             jalon_bytes** out) {
  return guard([&] {
    require(evaluation, "evaluation");
    require(out, "out");
    *out = bytes_of(BytesKind::kModelEvaluation, nullptr,
                    [&](ByteWriter& w) { write_model_evaluation(w, evaluation->evaluation); });
  });
}

jalon_status jalon_model_evaluation_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                               jalon_model_evaluation** out) {
  return guard([&] {
    require(out, "out");
    *out = read_bytes(bytes, byte_count, BytesKind::kModelEvaluation, nullptr,
                      [](ByteReader& r, Task&) {
                        auto handle = std::make_unique<jalon_model_evaluation>();
                        handle->evaluation = read_model_evaluation(r);
                        return own(handle.release());
                      })
               .release();
  });
}

jalon_status jalon_noise_law_to_bytes(const jalon_noise_law* law, jalon_bytes** out) {
  return guard([&] {
    require(law, "law");
    require(out, "out");
    *out = bytes_of(BytesKind::kNoiseLaw, nullptr,
                    [&](ByteWriter& w) { write_noise_law(w, law->law); });
  });
}

jalon_status jalon_noise_law_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                        jalon_noise_law** out) {
  return guard([&] {
    require(out, "out");
    *out = read_bytes(bytes, byte_count, BytesKind::kNoiseLaw, nullptr, [](ByteReader& r, Task&) {
             auto handle = std::make_unique<jalon_noise_law>();
             handle->law = read_noise_law(r);
             handle->json = to_json(handle->law);
             return own(handle.release());
           }).release();
  });
}
