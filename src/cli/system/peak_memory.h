// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <fstream>
#include <string>

#include "cli/system/memory.h"

namespace jalon::cli {

/// The most memory that the process has beyond what it has now, from here to peak_bytes(). Linux counts it; NaN where
/// nothing does.
class PeakMemory {
 public:
  PeakMemory() {
    give_back_memory();                             // what earlier work has freed is not this one's
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak starts from what there is now
    before_ = status_bytes("VmRSS:");
  }
  double peak_bytes() const { return status_bytes("VmHWM:") - before_; }

 private:
  static double status_bytes(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
      if (line.starts_with(name))
        return 1024.0 * static_cast<double>(std::stoll(line.substr(name.size())));
    return NAN;
  }
  double before_;
};

}  // namespace jalon::cli
