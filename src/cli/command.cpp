// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/command.h"

#include <charconv>
#include <cmath>

#include <CLI/CLI.hpp>

namespace jalon::cli {

namespace {

// CLI11's own checks let nan pass and tell ranges with the 309 digits of the largest double.
CLI::Validator number_check(const char* type, const char* wanted, bool (*is_wanted)(double)) {
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        double value = 0;
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        if (error == std::errc() && stop == end && std::isfinite(value) && is_wanted(value))
          return "";
        return "\"" + text + "\" is " + wanted;
      },
      type);
}

const CLI::Validator kNumber =
    number_check("", "no number", [](double value) { return std::isfinite(value); });
const CLI::Validator kWhole =
    number_check("", "no whole number", [](double value) { return value == std::trunc(value); });
const CLI::Validator kText([](std::string& text) { return text.empty() ? "needs a value" : ""; },
                           "");

// The number of a command's argument list that is the command: options before it have no values.
int place_of_command(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (argv[i][0] != '-') return i;
  return argc;
}

/// What is wrong with the arguments up to the command, "" where nothing is: CLI11 knows no more
/// than that one is required, and with --help anywhere says nothing.
std::string fault_of_command(const CLI::App& app, int argc, char** argv) {
  std::string known;
  const int place = place_of_command(argc, argv);
  for (const CLI::App* command : app.get_subcommands({})) {
    if (place < argc && command->get_name() == argv[place]) known = "this one";
    if (known != "this one") known += (known.empty() ? "" : ", ") + command->get_name();
  }
  for (int i = 1; i < place; ++i)
    if (app.get_option_no_throw(argv[i]) == nullptr)
      return "no option \"" + std::string(argv[i]) + "\" before the command";
  if (place < argc)
    return known == "this one"
               ? ""
               : "no command \"" + std::string(argv[place]) + "\"; there are: " + known;
  return argc > 1 ? "" : "a command is missing; there are: " + known;
}

// "--output: At Most 1 required but received 2" is no English.
std::string what_is_wrong(const CLI::ParseError& error) {
  std::string text = error.what();
  const auto put = [&](const std::string& of_cli11, const std::string& ours) {
    if (const size_t at = text.find(of_cli11); at != std::string::npos)
      text.replace(at, of_cli11.size(), ours);
  };
  put("At Most 1 required but received ", "takes one value, not ");
  put("At least 2 required but received ", "takes two values, not ");
  put("The following argument was not expected:", "unexpected argument");
  put("The following arguments were not expected:", "unexpected arguments");
  return text;
}

int tell_usage(const CLI::App& app, const std::string& what) {
  const auto given = app.get_subcommands();
  const std::string command = given.empty() ? "" : " " + given[0]->get_name();
  std::fprintf(stderr, "jalon%s: %s (help: jalon%s --help)\n", command.c_str(), what.c_str(),
               command.c_str());
  return 2;
}

}  // namespace

Option& Option::required(bool is_required) {
  option_->required(is_required);
  return *this;
}
Option& Option::type_name(const char* text) {
  option_->type_name(text);
  return *this;
}
Option& Option::shows_default() {
  option_->capture_default_str();
  return *this;
}
Option& Option::default_text(const char* text) {
  option_->default_val(std::string(text));
  return *this;
}
Option& Option::one_each_time() {
  option_->allow_extra_args(false);
  return *this;
}
Option& Option::expected(int least, int most) {
  option_->expected(least, most);
  return *this;
}
Option& Option::positive() {
  option_->check(number_check("above 0", "no number above 0", [](double v) { return v > 0; }));
  return *this;
}
Option& Option::non_negative() {
  option_->check(
      number_check("from 0", "no number from 0 upwards", [](double v) { return v >= 0; }));
  return *this;
}
Option& Option::between(int least, int most) {
  option_->check(CLI::Range(least, most));
  return *this;
}
Option& Option::among(const std::vector<std::string>& names) {
  option_->check(CLI::IsMember(names));
  return *this;
}

Command Command::subcommand(const char* name, const char* help) {
  return Command(app_->add_subcommand(name, help));
}

Option Command::option(const std::string& name, std::string& value, const std::string& help) {
  return Option(app_->add_option(name, value, help)->check(kText));
}
Option Command::option(const std::string& name, double& value, const std::string& help) {
  return Option(app_->add_option(name, value, help)->check(kNumber));
}
Option Command::option(const std::string& name, int64_t& value, const std::string& help) {
  return Option(app_->add_option(name, value, help)->check(kWhole));
}
Option Command::option(const std::string& name, unsigned& value, const std::string& help) {
  return Option(app_->add_option(name, value, help)->check(kWhole));
}
Option Command::option(const std::string& name, std::vector<std::string>& values,
                       const std::string& help) {
  return Option(app_->add_option(name, values, help)->check(kText));
}
Option Command::option(const std::string& name, std::vector<double>& values,
                       const std::string& help) {
  return Option(app_->add_option(name, values, help)->check(kNumber));
}

void Command::flag(const std::string& name, bool& value, const std::string& help) {
  app_->add_flag(name, value, help);
}
void Command::flag(const std::string& name, std::function<void()> on_given,
                   const std::string& help) {
  app_->add_flag_callback(name, std::move(on_given), help);
}
void Command::footer(std::function<std::string()> text) { app_->footer(std::move(text)); }
void Command::footer(const char* text) { app_->footer(text); }
void Command::on_run(std::function<void()> run) { app_->callback(std::move(run)); }

int run_commands(int argc, char** argv, const char* about, const char* footer, const char* version,
                 const std::function<void(Command&)>& declare) {
  CLI::App app{about, "jalon"};
  app.footer(footer);
  app.set_version_flag("--version", version);
  app.require_subcommand(1);
  Command all(&app);
  declare(all);
  if (const std::string fault = fault_of_command(app, argc, argv); !fault.empty())
    return tell_usage(app, fault);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : tell_usage(app, what_is_wrong(error));
  }
}

}  // namespace jalon::cli
