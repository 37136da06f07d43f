// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <tuple>
#include <type_traits>
#include <utility>

#include "base/params.h"

/// Rows bound to the members of a settings struct S. A parameter is said once, as a row; its default
/// is the initialiser of the member:
///
///   enum class Keep { kNearest, kFirst };
///   struct ThinSettings {
///     double spacing_m = 0.02;
///     Keep keep = Keep::kNearest;
///   };
///   constexpr auto kRows = setting_rows(
///       number_row<&ThinSettings::spacing_m>("spacing_m", 1e-5, 10, "m", "", "Least distance."),
///       choice_row<&ThinSettings::keep>("keep", "nearest|first", "", "Which point stays."));
///   std::span<const ParamRow> thin_rows() { return kRows; }
///
/// Members: double; int, int64_t, uint32_t, uint64_t; bool; std::string; an enum whose values are the
/// places of the choices, from 0; std::vector<double>. settings_from<S>(params) of params.h makes the
/// struct.
namespace jalon {

namespace rows {

template <class M>
struct MemberTraits;
template <class S, class T>
struct MemberTraits<T S::*> {
  using Settings = S;
  using Type = T;
};
template <auto M>
using SettingsOf = typename MemberTraits<decltype(M)>::Settings;
template <auto M>
using TypeOf = std::remove_cv_t<typename MemberTraits<decltype(M)>::Type>;

template <auto M>
ParamValue save(const ParamRow& row, const void* settings) {
  using T = TypeOf<M>;
  const auto& member = static_cast<const SettingsOf<M>*>(settings)->*M;
  ParamValue value;
  if constexpr (std::is_same_v<T, bool>) value.flag = member;
  else if constexpr (std::is_same_v<T, double>) value.number = member;
  else if constexpr (std::is_integral_v<T>) value.integer = static_cast<int64_t>(member);
  else if constexpr (std::is_enum_v<T>) value.text = choice_at(row, static_cast<size_t>(member));
  else if constexpr (std::is_same_v<T, std::string>) value.text = member;
  else value.numbers = member;
  return value;
}

template <auto M>
void load(const ParamRow& row, const ParamValue& value, void* settings) {
  using T = TypeOf<M>;
  auto& member = static_cast<SettingsOf<M>*>(settings)->*M;
  if constexpr (std::is_same_v<T, bool>) member = value.flag;
  else if constexpr (std::is_same_v<T, double>) member = value.number;
  else if constexpr (std::is_integral_v<T>) member = static_cast<T>(value.integer);
  else if constexpr (std::is_enum_v<T>) member = static_cast<T>(choice_place(row, value.text));
  else if constexpr (std::is_same_v<T, std::string>) member = value.text;
  else member = value.numbers;
}

template <auto M>
ParamValue initial(const ParamRow& row) {
  const SettingsOf<M> settings{};
  return save<M>(row, &settings);
}

template <auto M>
constexpr ParamRow bound(ParamRow row) {
  row.initial = initial<M>;
  row.save = save<M>;
  row.load = load<M>;
  row.settings = &kSettingsTag<SettingsOf<M>>;
  return row;
}

}  // namespace rows

template <auto M>
constexpr ParamRow number_row(const char* name, double minimum, double maximum, const char* unit,
                              const char* methods, const char* help) {
  static_assert(std::is_same_v<rows::TypeOf<M>, double>);
  return rows::bound<M>({name, ParamType::kDouble, unit, methods, help, "", minimum, maximum});
}
template <auto M>
constexpr ParamRow integer_row(const char* name, double minimum, double maximum, const char* unit,
                               const char* methods, const char* help) {
  static_assert(std::is_integral_v<rows::TypeOf<M>> && !std::is_same_v<rows::TypeOf<M>, bool>);
  return rows::bound<M>({name, ParamType::kInt64, unit, methods, help, "", minimum, maximum});
}
template <auto M>
constexpr ParamRow bool_row(const char* name, const char* methods, const char* help) {
  static_assert(std::is_same_v<rows::TypeOf<M>, bool>);
  return rows::bound<M>({name, ParamType::kBool, "", methods, help});
}
template <auto M>
constexpr ParamRow string_row(const char* name, const char* methods, const char* help) {
  static_assert(std::is_same_v<rows::TypeOf<M>, std::string>);
  return rows::bound<M>({name, ParamType::kString, "", methods, help});
}
template <auto M>
constexpr ParamRow choice_row(const char* name, const char* choices, const char* methods,
                              const char* help) {
  static_assert(std::is_enum_v<rows::TypeOf<M>> || std::is_same_v<rows::TypeOf<M>, std::string>);
  return rows::bound<M>({name, ParamType::kChoice, "", methods, help, choices});
}
template <auto M>
constexpr ParamRow doubles_row(const char* name, double minimum, double maximum, const char* unit,
                               const char* methods, const char* help) {
  return rows::bound<M>({name, ParamType::kDoubles, unit, methods, help, "", minimum, maximum});
}

namespace rows {

/// Row I of the table Inner, bound to the member Outer that is Inner's settings struct.
template <auto Outer, const auto& Inner, size_t I>
constexpr ParamRow nested_row() {
  ParamRow row = Inner[I];
  row.initial = [](const ParamRow& r) {
    const SettingsOf<Outer> settings{};
    return Inner[I].save(r, &(settings.*Outer));
  };
  row.save = [](const ParamRow& r, const void* settings) {
    return Inner[I].save(r, &(static_cast<const SettingsOf<Outer>*>(settings)->*Outer));
  };
  row.load = [](const ParamRow& r, const ParamValue& value, void* settings) {
    Inner[I].load(r, value, &(static_cast<SettingsOf<Outer>*>(settings)->*Outer));
  };
  row.settings = &kSettingsTag<SettingsOf<Outer>>;
  return row;
}

template <class R>
inline constexpr size_t kCount = 1;
template <size_t N>
inline constexpr size_t kCount<std::array<ParamRow, N>> = N;

constexpr void put(ParamRow*& to, const ParamRow& row) { *to++ = row; }
template <size_t N>
constexpr void put(ParamRow*& to, const std::array<ParamRow, N>& table) {
  for (const ParamRow& row : table) *to++ = row;
}

}  // namespace rows

/// The rows of a settings struct that is a member of another: nested_rows<&DistanceSettings::depth, kDepthRows>().
/// Inner is a constexpr array with static storage.
template <auto Outer, const auto& Inner>
constexpr auto nested_rows() {
  return []<size_t... I>(std::index_sequence<I...>) {
    return std::array<ParamRow, sizeof...(I)>{rows::nested_row<Outer, Inner, I>()...};
  }
  (std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<decltype(Inner)>>>{});
}

/// A table of rows and of tables, in this order.
template <class... R>
constexpr auto setting_rows(const R&... parts) {
  std::array<ParamRow, (rows::kCount<R> + ...)> all{};
  ParamRow* to = all.data();
  (rows::put(to, parts), ...);
  return all;
}

}  // namespace jalon
