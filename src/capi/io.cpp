// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/io.h"

#include "capi/support/guard.h"
#include "capi/support/model_handles.h"
#include "formats/formats.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

std::string require_path(const char* path, const char* name = "path") {
  std::string text = require_text(path, name);
  if (text.empty()) fail(Status::kInvalidArgument, "%s is empty", name);
  return text;
}

}  // namespace

jalon_status jalon_cloud_read(const char* path, const jalon_params* options, jalon_task* task,
                              jalon_cloud** out) {
  return guard([&] {
    require(out, "out");
    const std::string file = require_path(path);
    const ParamSet values = options_or_default(options, "read");
    *out = with_task(task, [&](Task& t) {
             return own(new_cloud(read_cloud(file, settings_from<ReadSettings>(values), t)));
           }).release();
  });
}

jalon_status jalon_cloud_write(const jalon_cloud* cloud, const char* path,
                               const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    const std::string file = require_path(path);
    const ParamSet values = options_or_default(options, "write");
    with_task(task, [&](Task& t) {
      write_cloud(*cloud->cloud, file, settings_from<WriteSettings>(values), t);
    });
  });
}

jalon_status jalon_cloud_convert(const char* source, const char* target,
                                 const jalon_params* options, jalon_task* task, uint64_t* out) {
  return guard([&] {
    require(out, "out");
    const std::string from = require_path(source, "source"), to = require_path(target, "target");
    const ParamSet values = options_or_default(options, "convert");
    *out = with_task(task, [&](Task& t) {
      return convert_cloud(from, to, settings_from<ConvertSettings>(values), t);
    });
  });
}

jalon_status jalon_model_read(const char* path, const jalon_params* options, jalon_task* task,
                              jalon_model** out) {
  return guard([&] {
    require(out, "out");
    const std::string file = require_path(path);
    const ParamSet values = options_or_default(options, "read");
    auto handle = std::make_unique<jalon_model>();
    with_task(task, [&](Task& t) {
      handle->model =
          std::make_shared<const Model>(read_model(file, settings_from<ReadSettings>(values), t));
    });
    *out = handle.release();
  });
}

jalon_status jalon_model_write(const jalon_model* model, const char* path,
                               const jalon_params* options, jalon_task* task) {
  return guard([&] {
    require(model, "model");
    const std::string file = require_path(path);
    const ParamSet values = options_or_default(options, "write");
    with_task(task, [&](Task& t) {
      write_model(*model->model, file, settings_from<WriteSettings>(values), t,
                  model->attributes.get());
    });
  });
}

jalon_status jalon_format_count(uint64_t* out) {
  return guard([&] {
    require(out, "out");
    *out = formats().size();
  });
}

jalon_status jalon_format_info(uint64_t i, const char** name, const char** extensions,
                               const char** abilities) {
  return guard([&] {
    if (i >= formats().size())
      fail(Status::kInvalidArgument, "there are %zu formats", formats().size());
    const FormatInfo& format = formats()[i];
    if (name != nullptr) *name = format.name;
    if (extensions != nullptr) *extensions = format.extensions;
    if (abilities != nullptr) *abilities = format.abilities;
  });
}
