// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include "base/params.h"
#include "capi/support/guard.h"

/// What the workers (segmenter, modeller, comparer, registrar, scanner) have in common. A worker's room lists its
/// methods in a table, the default first: segment_methods(), registration_methods(). A row has
///   name, owner (of its parameters: "segmenter ransac"), rows(), and functions that run it, nullptr where it cannot.
/// A worker's handle has
///   method (a row of that table) and values (shared with its jalon_params handles).
namespace jalon::capi {

/// The method of that name; else the error names those there are. what: "segmentation method".
template <class Method>
const Method& find_method(std::span<const Method> methods, const std::string& name,
                          const char* what) {
  std::string names;
  for (const Method& method : methods) {
    if (name == method.name) return method;
    names += (names.empty() ? "" : ", ") + std::string(method.name);
  }
  fail(Status::kNotFound, "no %s \"%.100s\"; there are: %s", what, name.c_str(), names.c_str());
}

/// jalon_..._create: name NULL is the default method.
template <class Worker, class Method>
jalon_status create_worker(std::span<const Method> methods, const char* name, const char* what,
                           Worker** out) {
  return guard([&] {
    require(out, "out");
    const Method& method = name == nullptr
                               ? methods.front()
                               : find_method(methods, require_text(name, "method"), what);
    auto handle = std::make_unique<Worker>();
    handle->method = &method;
    handle->values = std::make_shared<ParamSet>(method.owner, method.rows());
    *out = handle.release();
  });
}

/// A new worker of the same method with values of its own.
template <class Worker>
std::unique_ptr<Worker> copy_of(const Worker& worker) {
  auto handle = std::make_unique<Worker>();
  handle->method = worker.method;
  handle->values = std::make_shared<ParamSet>(*worker.values);
  return handle;
}
/// jalon_..._copy of workers that hold nothing else.
template <class Worker>
jalon_status copy_worker(const Worker* worker, const char* name, Worker** out) {
  return guard([&] {
    require(worker, name);
    require(out, "out");
    *out = copy_of(*worker).release();
  });
}

/// jalon_..._methods: the static names that the table has (kNamesOf).
inline void give_names(std::span<const char* const> from, const char* const** names,
                       uint64_t* count) {
  require(names, "names");
  require(count, "count");
  *names = from.data();
  *count = from.size();
}

/// jalon_..._params: a handle that shares the worker's values.
template <class Worker>
jalon_status give_worker_params(Worker* worker, const char* name, jalon_params** out) {
  return guard([&] {
    require(worker, name);
    require(out, "out");
    auto handle = std::make_unique<jalon_params>();
    handle->operation = worker->method->owner;
    handle->values = worker->values;
    *out = handle.release();
  });
}

/// The method's function of this kind; else the error says what it does not do, and names the first that does:
/// require_run(registration_methods(), *worker->method, &RegistrationMethod::run_targets, "registers clouds").
template <class Method, class Run>
Run require_run(std::span<const Method> methods, const Method& method, Run Method::*run,
                const char* limit) {
  if (method.*run != nullptr) return method.*run;
  for (const Method& other : methods)
    if (other.*run != nullptr)
      fail(Status::kUnsupported, "method \"%s\" %s; use \"%s\"", method.name, limit, other.name);
  fail(Status::kUnsupported, "method \"%s\" %s", method.name, limit);
}

/// The last part of jalon_..._run, after the checks of the arguments: body(values, task) under the caller's task; gives
/// back what it gives. The values are a copy: a progress callback may set the next run's, or release the worker.
template <class Worker, class F>
auto run_worker(const Worker& worker, jalon_task* task, F&& body) {
  const ParamSet values = *worker.values;
  return with_task(task, [&](Task& t) { return body(values, t); });
}

}  // namespace jalon::capi
