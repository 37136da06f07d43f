// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/command.h"

#include <CLI/CLI.hpp>

namespace jalon::cli {

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
  option_->check(CLI::PositiveNumber);
  return *this;
}
Option& Option::non_negative() {
  option_->check(CLI::NonNegativeNumber);
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
  return Option(app_->add_option(name, value, help));
}
Option Command::option(const std::string& name, double& value, const std::string& help) {
  return Option(app_->add_option(name, value, help));
}
Option Command::option(const std::string& name, int64_t& value, const std::string& help) {
  return Option(app_->add_option(name, value, help));
}
Option Command::option(const std::string& name, unsigned& value, const std::string& help) {
  return Option(app_->add_option(name, value, help));
}
Option Command::option(const std::string& name, std::vector<std::string>& values,
                       const std::string& help) {
  return Option(app_->add_option(name, values, help));
}
Option Command::option(const std::string& name, std::vector<double>& values,
                       const std::string& help) {
  return Option(app_->add_option(name, values, help));
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
  CLI::App app{about};
  app.footer(footer);
  app.set_version_flag("--version", version);
  app.require_subcommand(1);
  Command all(&app);
  declare(all);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
}

}  // namespace jalon::cli
