// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace jalon::cli {

/// An option of a command, to be described further: command.option(...).required().type_name("FILE").
/// CLI11 itself is seen by command.cpp alone: its templates would be most of what every command's file compiles.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required(bool is_required = true);
  Option& type_name(const char* text);
  /// --help shows what the variable holds now.
  Option& shows_default();
  Option& default_text(const char* text);
  /// One value each time; repeatable.
  Option& one_each_time();
  Option& expected(int least, int most);
  Option& positive();
  Option& non_negative();
  Option& between(int least, int most);
  Option& among(const std::vector<std::string>& names);

 private:
  CLI::Option* option_;
};

/// A command of the tool, or the tool itself. Variables outlive the parsing.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  Command subcommand(const char* name, const char* help);
  Option option(const std::string& name, std::string& value, const std::string& help);
  Option option(const std::string& name, double& value, const std::string& help);
  Option option(const std::string& name, int64_t& value, const std::string& help);
  Option option(const std::string& name, unsigned& value, const std::string& help);
  Option option(const std::string& name, std::vector<std::string>& values, const std::string& help);
  Option option(const std::string& name, std::vector<double>& values, const std::string& help);
  void flag(const std::string& name, bool& value, const std::string& help);
  void flag(const std::string& name, std::function<void()> on_given, const std::string& help);
  void footer(std::function<std::string()> text);
  void footer(const char* text);
  void on_run(std::function<void()> run);

 private:
  CLI::App* app_;
};

/// Declares the commands and runs the one that the arguments name; what it throws passes. Returns the
/// exit status: 0, or 2 where the arguments are wrong, which it has then said.
int run_commands(int argc, char** argv, const char* about, const char* footer, const char* version,
                 const std::function<void(Command&)>& declare);

}  // namespace jalon::cli
