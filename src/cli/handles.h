// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "jalon/jalon.h"

namespace jalon::cli {

/// A failed call: its status and line, carried to main, which turns it into an exit code.
struct Failure {
  jalon_status status;
  std::string text;
};

/// Every call of the C API goes through here.
inline void must(jalon_status status) {
  if (status != JALON_OK) throw Failure{status, jalon_last_error_message()};
}

/// A call that reads a file: what the system refuses of it is wrong with the input, as what its content lacks.
inline void must_read(jalon_status status) {
  if (status == JALON_ERROR_IO) throw Failure{JALON_ERROR_NOT_FOUND, jalon_last_error_message()};
  must(status);
}

/// A call that looks up a name that an option gave, of a method for one: an unknown one is a wrong option.
inline void must_know(jalon_status status) {
  if (status == JALON_ERROR_NOT_FOUND)
    throw Failure{JALON_ERROR_INVALID_ARGUMENT, jalon_last_error_message()};
  must(status);
}

/// Owner of a handle: unique_ptr with the noun's release.
template <auto release>
struct Release {
  template <class T>
  void operator()(T* handle) const {
    release(handle);
  }
};
using Adjustment = std::unique_ptr<jalon_adjustment, Release<jalon_adjustment_release>>;
using Cloud = std::unique_ptr<jalon_cloud, Release<jalon_cloud_release>>;
using Comparer = std::unique_ptr<jalon_comparer, Release<jalon_comparer_release>>;
using Comparison = std::unique_ptr<jalon_comparison, Release<jalon_comparison_release>>;
using Evaluation = std::unique_ptr<jalon_evaluation, Release<jalon_evaluation_release>>;
using Fields = std::unique_ptr<jalon_fields, Release<jalon_fields_release>>;
using Model = std::unique_ptr<jalon_model, Release<jalon_model_release>>;
using ModelEvaluation =
    std::unique_ptr<jalon_model_evaluation, Release<jalon_model_evaluation_release>>;
using Modeller = std::unique_ptr<jalon_modeller, Release<jalon_modeller_release>>;
using Network = std::unique_ptr<jalon_network, Release<jalon_network_release>>;
using NoiseLaw = std::unique_ptr<jalon_noise_law, Release<jalon_noise_law_release>>;
using Params = std::unique_ptr<jalon_params, Release<jalon_params_release>>;
using Registrar = std::unique_ptr<jalon_registrar, Release<jalon_registrar_release>>;
using Registration = std::unique_ptr<jalon_registration, Release<jalon_registration_release>>;
using Scanner = std::unique_ptr<jalon_scanner, Release<jalon_scanner_release>>;
using Segmentation = std::unique_ptr<jalon_segmentation, Release<jalon_segmentation_release>>;
using Segmenter = std::unique_ptr<jalon_segmenter, Release<jalon_segmenter_release>>;
using Trajectory = std::unique_ptr<jalon_trajectory, Release<jalon_trajectory_release>>;
using Task = std::unique_ptr<jalon_task, Release<jalon_task_release>>;

/// Output argument of a call: must(jalon_cloud_read(path, nullptr, task, Out(cloud))).
template <class Owner>
class Out {
 public:
  explicit Out(Owner& owner) : owner_(owner) {}
  ~Out() {
    if (raw_ != nullptr) owner_.reset(raw_);
  }
  operator typename Owner::pointer *() { return &raw_; }

 private:
  Owner& owner_;
  typename Owner::pointer raw_ = nullptr;
};

/// Typed elements of a column.
template <class T>
const T* values(const Fields& fields, const char* name, uint64_t* count = nullptr) {
  jalon_array_view view;
  must(jalon_fields_view(fields.get(), name, &view));
  if (count != nullptr) *count = view.count;
  return static_cast<const T*>(view.data);
}

}  // namespace jalon::cli
