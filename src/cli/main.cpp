// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// jalon: the command line tool. It sees the public headers only.

#include <cstdio>
#include <exception>
#include <new>

#include "cli/options.h"
#include "cli/system/memory.h"

namespace jalon::cli {

namespace {

constexpr const char* kFooter = R"(
Exit codes (README.md has the same table; nothing is written but with 0, and the report of a registration with 5):
    0  done
    1  internal error: please report it
    2  wrong command, option, parameter or method
    3  input missing, unreadable or malformed, or without a field that was asked for
    4  output cannot be written
    5  too few points, or nothing found in them; scans that lie apart; a registration that is not accepted
    6  not supported: a format, or a parameter together with another
    7  out of memory
  130  cancelled by Ctrl-C
Every code but 0 comes with one line on standard error. Existing output is replaced only by complete output.

Examples:
  jalon info scan.las
  jalon facade scan.las -o result
  jalon model segments.las -o result --labels label
  jalon compare before.las after.las -o result
  jalon scan --scene facade -o sample.las
Help on a command: jalon facade --help)";

int exit_code(jalon_status status) {
  switch (status) {
    case JALON_ERROR_INVALID_ARGUMENT:
      return 2;
    case JALON_ERROR_NOT_FOUND:
    case JALON_ERROR_FORMAT:
      return 3;
    case JALON_ERROR_IO:
      return 4;
    case JALON_ERROR_INSUFFICIENT_DATA:
    case JALON_ERROR_DEGENERATE:
      return 5;
    case JALON_ERROR_UNSUPPORTED:
    case JALON_ERROR_LIMIT:
      return 6;
    case JALON_ERROR_OUT_OF_MEMORY:
      return 7;
    case JALON_ERROR_CANCELLED:
      return 130;
    default:
      return 1;
  }
}

int run(int argc, char** argv) {
  return_large_blocks();
  const auto declare = [](Command& app) {
    add_info(app);
    add_convert(app);
    add_formats(app);
    add_clean(app);
    add_cut(app);
    add_sections(app);
    add_normals(app);
    add_facade(app);
    add_segment(app);
    add_targets(app);
    add_code(app);
    add_network(app);
    add_model(app);
    add_evaluate(app);
    add_evaluate_model(app);
    add_register(app);
    add_adjust(app);
    add_compare(app);
    add_clearance(app);
    add_scan(app);
  };
  try {
    return run_commands(argc, argv,
                        "Jalon: laser scans in, planes, facade models and drawings out.", kFooter,
                        (std::string("jalon ") + jalon_version()).c_str(), declare);
  } catch (const Failure& failure) {
    std::fprintf(stderr, "jalon: %s\n", failure.text.c_str());
    return exit_code(failure.status);
  } catch (const std::bad_alloc&) {
    std::fputs("jalon: out of memory\n", stderr);
    return 7;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "jalon: internal error: %s\n", error.what());
    return 1;
  }
}

}  // namespace

}  // namespace jalon::cli

int main(int argc, char** argv) { return jalon::cli::run(argc, argv); }
