// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Parameters as bytes, and the workers, which are a method and its parameters. Both are told by the owner of the
// table: an operation ("normals") or the method of a worker ("segmenter ransac").
#include "bytes/param_values.h"
#include "capi/support/bytes_handle.h"
#include "capi/support/comparison_handles.h"
#include "capi/support/methods.h"
#include "capi/support/model_handles.h"
#include "capi/support/operations.h"
#include "capi/support/registration_handles.h"
#include "capi/support/scan_handles.h"
#include "capi/support/worker_handles.h"

using namespace jalon;
using namespace jalon::capi;

namespace {

// The name that lives for ever, and the rows.
struct Table {
  const char* owner = nullptr;
  std::span<const ParamRow> rows;
};

template <class Method>
const Method* method_of(std::span<const Method> methods, const std::string& owner) {
  for (const Method& method : methods)
    if (owner == method.owner) return &method;
  return nullptr;
}

template <class Method>
bool find_among(std::span<const Method> methods, const std::string& owner, Table& out) {
  const Method* method = method_of(methods, owner);
  if (method != nullptr) out = {method->owner, method->rows()};
  return method != nullptr;
}

Table table_of(const ByteReader& reader, const std::string& owner) {
  Table out;
  for (const Operation& operation : operations())
    if (owner == operation.name) return {operation.name, operation.rows()};
  if (!find_among(segment_methods(), owner, out) && !find_among(modelling_methods(), owner, out) &&
      !find_among(compare_methods(), owner, out) &&
      !find_among(registration_methods(), owner, out) && !find_among(scanner_methods(), owner, out))
    reader.refuse("this release has no parameters of \"%.100s\"", owner.c_str());
  return out;
}

template <class Worker>
void write_worker(ByteWriter& writer, const Worker& worker) {
  writer.text(worker.method->owner);
  write_values(writer, *worker.values);
}

template <class Worker, class Method>
Owned<Worker> read_worker(ByteReader& reader, std::span<const Method> methods) {
  const auto owner = reader.take<std::string>();
  auto handle = std::make_unique<Worker>();
  handle->method = method_of(methods, owner);
  if (handle->method == nullptr)
    reader.refuse("this release has no method \"%.100s\"", owner.c_str());
  handle->values = std::make_shared<ParamSet>(handle->method->owner, handle->method->rows());
  read_values(reader, *handle->values);
  return own(handle.release());
}

// jalon_..._to_bytes and jalon_..._from_bytes of workers that hold nothing else.
template <class Worker>
jalon_status worker_to_bytes(const Worker* worker, const char* name, BytesKind kind,
                             jalon_bytes** out) {
  return guard([&] {
    require(worker, name);
    require(out, "out");
    *out = bytes_of(kind, nullptr, [&](ByteWriter& w) { write_worker(w, *worker); });
  });
}

template <class Worker, class Method>
jalon_status worker_from_bytes(const uint8_t* bytes, uint64_t byte_count, BytesKind kind,
                               std::span<const Method> methods, Worker** out) {
  return guard([&] {
    require(out, "out");
    *out = read_bytes(bytes, byte_count, kind, nullptr, [&](ByteReader& r, Task&) {
             return read_worker<Worker>(r, methods);
           }).release();
  });
}

void write_stations(ByteWriter& writer, const std::vector<ScanStation>& stations) {
  writer.item(static_cast<uint64_t>(stations.size()));
  for (const ScanStation& station : stations) {
    writer.item(station.name);
    writer.item(station.pose);
  }
}

std::vector<ScanStation> read_stations(ByteReader& reader) {
  std::vector<ScanStation> stations(
      reader.count(least_bytes<std::string>() + least_bytes<Transform>()));
  for (ScanStation& station : stations) {
    reader.item(station.name);
    reader.item(station.pose);
    try {
      require_rigid(station.pose, "a station's pose");
    } catch (const Error& error) {
      reader.refuse("%s", error.what());
    }
  }
  return stations;
}

}  // namespace

jalon_status jalon_params_to_bytes(const jalon_params* params, jalon_bytes** out) {
  return guard([&] {
    require(params, "params");
    require(out, "out");
    *out = bytes_of(BytesKind::kParams, nullptr, [&](ByteWriter& w) {
      w.text(params->operation);
      write_values(w, *params->values);
    });
  });
}

jalon_status jalon_params_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                     jalon_params** out) {
  return guard([&] {
    require(out, "out");
    *out = read_bytes(bytes, byte_count, BytesKind::kParams, nullptr, [](ByteReader& r, Task&) {
             const Table table = table_of(r, r.take<std::string>());
             auto handle = std::make_unique<jalon_params>();
             handle->operation = table.owner;
             handle->values = std::make_shared<ParamSet>(table.owner, table.rows);
             read_values(r, *handle->values);
             return own(handle.release());
           }).release();
  });
}

jalon_status jalon_segmenter_to_bytes(const jalon_segmenter* segmenter, jalon_bytes** out) {
  return worker_to_bytes(segmenter, "segmenter", BytesKind::kSegmenter, out);
}

jalon_status jalon_segmenter_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                        jalon_segmenter** out) {
  return worker_from_bytes(bytes, byte_count, BytesKind::kSegmenter, segment_methods(), out);
}

jalon_status jalon_modeller_to_bytes(const jalon_modeller* modeller, jalon_bytes** out) {
  return worker_to_bytes(modeller, "modeller", BytesKind::kModeller, out);
}

jalon_status jalon_modeller_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                       jalon_modeller** out) {
  return worker_from_bytes(bytes, byte_count, BytesKind::kModeller, modelling_methods(), out);
}

jalon_status jalon_comparer_to_bytes(const jalon_comparer* comparer, jalon_bytes** out) {
  return worker_to_bytes(comparer, "comparer", BytesKind::kComparer, out);
}

jalon_status jalon_comparer_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                       jalon_comparer** out) {
  return worker_from_bytes(bytes, byte_count, BytesKind::kComparer, compare_methods(), out);
}

jalon_status jalon_registrar_to_bytes(const jalon_registrar* registrar, jalon_bytes** out) {
  return worker_to_bytes(registrar, "registrar", BytesKind::kRegistrar, out);
}

jalon_status jalon_registrar_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                        jalon_registrar** out) {
  return worker_from_bytes(bytes, byte_count, BytesKind::kRegistrar, registration_methods(), out);
}

jalon_status jalon_scanner_to_bytes(const jalon_scanner* scanner, jalon_bytes** out) {
  return guard([&] {
    require(scanner, "scanner");
    require(out, "out");
    *out = bytes_of(BytesKind::kScanner, nullptr, [&](ByteWriter& w) {
      write_worker(w, *scanner);
      write_stations(w, scanner->stations);
    });
  });
}

jalon_status jalon_scanner_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                      jalon_scanner** out) {
  return guard([&] {
    require(out, "out");
    *out = read_bytes(bytes, byte_count, BytesKind::kScanner, nullptr, [](ByteReader& r, Task&) {
             auto handle = read_worker<jalon_scanner>(r, scanner_methods());
             handle->stations = read_stations(r);
             return handle;
           }).release();
  });
}
