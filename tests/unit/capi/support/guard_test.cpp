// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "capi/support/guard.h"
#include "capi/support/operations.h"

#include <doctest/doctest.h>

#include <any>
#include <filesystem>
#include <functional>
#include <future>
#include <ios>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <typeinfo>
#include <variant>
#include <vector>

using namespace jalon;

namespace {

struct Throw {
  const char* kind;
  void (*site)();
  jalon_status status;
  const char* told;  ///< part of the line
};

struct Unknown {};
struct Base {
  virtual ~Base() = default;
};
struct Other : Base {};
class Silent : public std::exception {
 public:
  const char* what() const noexcept override { return ""; }
};

Base& some_base() {
  static Base base;
  return base;
}

constexpr jalon_status kInternalCode = JALON_ERROR_INTERNAL;
const Throw kThrows[] = {
    {"bad_alloc", [] { throw std::bad_alloc(); }, JALON_ERROR_OUT_OF_MEMORY, "out of memory"},
    {"bad_array_new_length", [] { throw std::bad_array_new_length(); }, JALON_ERROR_OUT_OF_MEMORY,
     "out of memory"},
    {"length_error of a vector",
     [] { std::vector<int>().reserve(std::vector<int>().max_size() + 1); },
     JALON_ERROR_OUT_OF_MEMORY, "more elements than an array can hold"},
    {"bad_cast", [] { static_cast<void>(dynamic_cast<Other&>(some_base())); }, kInternalCode,
     "cast"},
    {"bad_typeid", [] { throw std::bad_typeid(); }, kInternalCode, "typeid"},
    {"bad_exception", [] { throw std::bad_exception(); }, kInternalCode, "exception"},
    {"bad_function_call", [] { std::function<void()>()(); }, kInternalCode, "function"},
    {"bad_optional_access", [] { static_cast<void>(std::optional<int>().value()); }, kInternalCode,
     "optional"},
    {"bad_variant_access", [] { static_cast<void>(std::get<1>(std::variant<int, char>())); },
     kInternalCode, "variant"},
    {"bad_any_cast", [] { static_cast<void>(std::any_cast<int>(std::any())); }, kInternalCode,
     "any"},
    {"bad_weak_ptr", [] { static_cast<void>(std::shared_ptr<int>(std::weak_ptr<int>())); },
     kInternalCode, "weak"},
    {"out_of_range", [] { static_cast<void>(std::vector<int>().at(3)); }, kInternalCode, "range"},
    {"invalid_argument of a number", [] { static_cast<void>(std::stoi("x")); }, kInternalCode,
     "stoi"},
    {"domain_error", [] { throw std::domain_error("domain"); }, kInternalCode, "domain"},
    {"logic_error", [] { throw std::logic_error("logic"); }, kInternalCode, "logic"},
    {"range_error", [] { throw std::range_error("a range"); }, kInternalCode, "a range"},
    {"overflow_error", [] { throw std::overflow_error("over"); }, kInternalCode, "over"},
    {"underflow_error", [] { throw std::underflow_error("under"); }, kInternalCode, "under"},
    {"system_error", [] { throw std::system_error(std::make_error_code(std::errc::io_error)); },
     kInternalCode, ""},
    {"future_error", [] { throw std::future_error(std::future_errc::no_state); }, kInternalCode,
     ""},
    {"filesystem_error", [] { static_cast<void>(std::filesystem::file_size("/no such file")); },
     kInternalCode, "/no such file"},
    {"regex_error", [] { std::regex("("); }, kInternalCode, ""},
    {"ios failure", [] { throw std::ios_base::failure("stream"); }, kInternalCode, "stream"},
    {"an exception without a word", [] { throw Silent(); }, kInternalCode, "internal error"},
    {"a line of several", [] { throw std::runtime_error("one\ntwo\r\tthree"); }, kInternalCode,
     "one two"},
    {"a line without end", [] { throw std::runtime_error(std::string(100000, 'x')); },
     kInternalCode, "xxx"},
    {"an int", [] { throw 7; }, kInternalCode, "unknown kind"},
    {"a text", [] { throw "a text"; }, kInternalCode, "unknown kind"},
    {"a pointer to nothing", [] { throw static_cast<std::exception*>(nullptr); }, kInternalCode,
     "unknown kind"},
    {"a struct of no family", [] { throw Unknown(); }, kInternalCode, "unknown kind"},
};

}  // namespace

TEST_CASE("guard__turns_every_kind_of_throw_into_a_status_and_one_line") {
  for (const Throw& t : kThrows) {
    CAPTURE(t.kind);
    CHECK(capi::guard([&] { t.site(); }) == t.status);
    const std::string_view line = capi::last_error_text();
    CAPTURE(line);
    CHECK(line.find(t.told) != std::string_view::npos);
    CHECK(!line.empty());
    CHECK(line.size() < 1024);
    for (const char c : line) CHECK(static_cast<unsigned char>(c) >= 0x20);
  }
  CHECK(std::size(kThrows) >= 20);
}

TEST_CASE("guard__gives_every_status_of_an_error_back_with_its_line") {
  for (int32_t code = -12; code < 0; ++code) {
    CHECK(capi::guard([&] { fail(static_cast<Status>(code), "number %d", code); }) == code);
    CHECK(std::string_view(capi::last_error_text()) == "number " + std::to_string(code));
  }
  CHECK(capi::guard([] {}) == JALON_OK);
}

TEST_CASE("guard__lets_a_throw_pass_that_was_caught_within_it") {
  CHECK(capi::guard([] {
          try {
            throw Unknown();
          } catch (const Unknown&) {
          }
        }) == JALON_OK);
  // One thrown while another is being dealt with ends alone.
  CHECK(capi::guard([] {
          try {
            throw std::runtime_error("first");
          } catch (const std::exception&) {
            fail(Status::kBusy, "second");
          }
        }) == JALON_ERROR_BUSY);
  CHECK(std::string_view(capi::last_error_text()) == "second");
}
