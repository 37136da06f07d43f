// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cli/handles.h"
#include "cli/options.h"

namespace jalon::cli {

/// The parameter table of each method of a worker, for --help, each below LEAD and its name:
/// method_tables<Segmenter>("Parameters of --set with --method ", jalon_segmenter_methods,
///                          jalon_segmenter_create, jalon_segmenter_params).
template <class Owner, class Worker = typename Owner::element_type>
std::string method_tables(const std::string& lead,
                          jalon_status (*methods)(const char* const** names, uint64_t* count),
                          jalon_status (*create)(const char* method, Worker** out),
                          jalon_status (*params_of)(Worker* worker, jalon_params** out)) {
  const char* const* names = nullptr;
  uint64_t count = 0;
  must(methods(&names, &count));
  std::string text;
  for (uint64_t i = 0; i < count; ++i) {
    Owner worker;
    Params params;
    must(create(names[i], Out(worker)));
    must(params_of(worker.get(), Out(params)));
    text += lead + names[i] + ":\n" + describe(params.get()) + "\n";
  }
  return text;
}

/// The method of a worker that is taken when none is named: default_method(jalon_registrar_methods).
inline std::string default_method(jalon_status (*methods)(const char* const** names,
                                                          uint64_t* count)) {
  const char* const* names = nullptr;
  uint64_t count = 0;
  must(methods(&names, &count));
  return names[0];
}

}  // namespace jalon::cli
