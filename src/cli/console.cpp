// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"

#include <atomic>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "cli/terminal.h"

namespace jalon::cli {

namespace {

constexpr int kBarCells = 30;

// The running command's task, for the signal handler alone; a tool has one command a process.
std::atomic<jalon_task*> interruptible{nullptr};

extern "C" void on_interrupt(int) {
  if (jalon_task* task = interruptible.load()) (void)!jalon_task_cancel(task);
}

}  // namespace

Console::Console(const Common& common)
    : common_(common), task_(another_task(on_log, this)), terminal_(prepare_terminal()) {
  if (!common.quiet && !common.json && terminal_)
    must(jalon_task_set_progress(task_.get(), on_progress, this));
  interruptible = task_.get();
  std::signal(SIGINT, on_interrupt);
  ignore_broken_pipes();
  step("working");
}

Console::~Console() {
  std::signal(SIGINT, SIG_DFL);
  interruptible = nullptr;
  clear_bar();
}

Task Console::another_task(jalon_log_callback log, void* user) const {
  Task out;
  must(jalon_task_create(Out(out)));
  must(jalon_task_set_threads(out.get(), common_.threads));
  must(jalon_task_set_memory_limit(out.get(), uint64_t{common_.memory_limit_mib} << 20));
  must(jalon_task_set_log(out.get(), log, user));
  return out;
}

void Console::step(const char* name) {
  step_ = name;
  started_ = std::chrono::steady_clock::now();
}

double Console::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

void Console::clear_bar() {
  if (!bar_shown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  bar_shown_ = false;
}

int32_t Console::on_progress(double fraction, const char* stage, void* user) {
  auto& self = *static_cast<Console*>(user);
  if (fraction >= 1) {
    self.clear_bar();
    return 0;
  }
  const int filled = static_cast<int>(fraction * kBarCells);
  std::string bar;
  for (int i = 0; i < kBarCells; ++i) bar += i < filled ? "█" : "░";
  std::fprintf(stderr, "\r\033[K%-10s %s %3d %%  %s", self.step_.c_str(), bar.c_str(),
               static_cast<int>(fraction * 100), stage);
  std::fflush(stderr);
  self.bar_shown_ = true;
  return 0;
}

void Console::on_log(int32_t level, const char* text, void* user) {
  auto& console = *static_cast<Console*>(user);
  if (level == JALON_LOG_INFO) console.told_.emplace_back(text);
  if (level < JALON_LOG_WARNING || console.common_.quiet || console.are_warnings_known_) return;
  console.clear_bar();
  std::fprintf(stderr, "jalon: warning: %s\n", text);
}

void Console::say(const std::string& line) const {
  if (!common_.quiet && !common_.json) std::printf("%s\n", line.c_str());
}

void Console::warn(const std::string& line) const {
  if (!common_.quiet) std::fprintf(stderr, "jalon: warning: %s\n", line.c_str());
}

void Console::result(const nlohmann::ordered_json& object) const {
  if (common_.json)
    std::printf(
        "%s\n",
        object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

std::string grouped(uint64_t number) {
  std::string digits = std::to_string(number);
  for (size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, " ");
  return digits;
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  char text[400];  // the longest double in fixed notation has 309 digits
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
  const std::string out(text, end.ptr);
  // "-0.00" looks like a side that is none.
  return out.find_first_not_of("-0.") == std::string::npos && out[0] == '-' ? out.substr(1) : out;
}

}  // namespace jalon::cli
