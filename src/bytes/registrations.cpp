// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/registrations.h"

#include <algorithm>
#include <cmath>

#include "bytes/tables.h"

namespace jalon {

namespace {

constexpr size_t kDirections = 6;
constexpr KnownColumn kDirectionColumns[] = {{"direction", ElementType::kFloat64, 6, true},
                                             {"sigma", ElementType::kFloat64, 1, true},
                                             {"observable", ElementType::kUint8, 1, true}};
constexpr KnownColumn kSummaryColumns[] = {{"converged", ElementType::kUint8, 1, true},
                                           {"stopped", ElementType::kUint8, 1, true},
                                           {"score", ElementType::kFloat64},
                                           {"thinning_cell", ElementType::kFloat64}};

template <Maybe<Registration> T>
auto registration_members(T& r) {
  return std::tie(r.pose, r.scale, r.converged, r.stopped, r.centre, r.covariance, r.pairs,
                  r.iterations, r.rms_m, r.extent_m, r.unobservable, r.judgement.verdict,
                  r.judgement.confidence, r.judgement.reasons);
}

void require_whole_registration(const ByteReader& reader, const Registration& r) {
  const auto is_number = [](double v) { return std::isfinite(v); };
  if (!std::all_of(r.pose.m.begin(), r.pose.m.end(), is_number))
    reader.refuse("the pose is not finite");
  if (r.stopped < StopReason::kConverged || r.stopped > StopReason::kNothingFound)
    reader.refuse("the reason for the end is unknown");
  if (r.judgement.verdict > Verdict::kRefused) reader.refuse("the verdict is unknown");
  require_known(reader, r.summary, kSummaryColumns);
  require_rows(reader, r.summary, "columns of the summary", 1);
  require_known(reader, r.directions, kDirectionColumns);
  require_rows(reader, r.directions, "directions", kDirections);
  const size_t rows = r.residuals.size() > 0 ? r.residuals.at(0)->count() : 0;
  if (r.pair_names.size() > rows) reader.refuse("there are more names than pairs");
}

}  // namespace

void write_registration(ByteWriter& writer, const Registration& registration) {
  std::apply([&](const auto&... member) { (writer.item(member), ...); },
             registration_members(registration));
  for (const FieldTable* table : {&registration.summary, &registration.iteration_log,
                                  &registration.residuals, &registration.directions})
    write_table(writer, *table);
  writer.list(registration.pair_names);
  writer.item(registration.parameters_json);
}

Registration read_registration(ByteReader& reader, Task& task) {
  Registration out;
  std::apply([&](auto&... member) { (reader.item(member), ...); }, registration_members(out));
  for (FieldTable* table : {&out.summary, &out.iteration_log, &out.residuals, &out.directions})
    *table = read_table(reader, task);
  reader.list(out.pair_names);
  reader.item(out.parameters_json);
  require_whole_registration(reader, out);
  return out;
}

}  // namespace jalon
