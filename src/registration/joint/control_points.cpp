// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/control_points.h"

#include "base/error.h"
#include "base/text_number.h"
#include "model/trajectory/interpolation.h"

namespace jalon {

std::vector<ControlCondition> control_points(std::span<const double> numbers,
                                             std::span<const double> control_times_s) {
  constexpr size_t kNumbers = 6;
  if (numbers.size() % kNumbers != 0)
    fail(Status::kInvalidArgument,
         "control_points has %zu numbers: each point has six, time, x, y, right x, right y, sigma",
         numbers.size());
  std::vector<ControlCondition> made;
  for (size_t first = 0; first < numbers.size(); first += kNumbers) {
    const double* p = numbers.data() + first;
    const size_t number = first / kNumbers;
    if (!(p[0] >= control_times_s.front() && p[0] <= control_times_s.back()))
      fail(Status::kInvalidArgument,
           "control point %zu was seen at %s s, outside of the trajectory's time, %s to %s", number,
           text_of(p[0]).c_str(), text_of(control_times_s.front()).c_str(),
           text_of(control_times_s.back()).c_str());
    if (!(p[5] > 0))
      fail(Status::kInvalidArgument, "control point %zu has a standard deviation of %s m", number,
           text_of(p[5]).c_str());
    const TimePlace at = time_place(control_times_s, p[0], number);
    const auto epoch = static_cast<uint32_t>(at.epoch);
    made.push_back(
        {{{epoch, 1 - at.share}, {epoch + 1, at.share}}, {p[3] - p[1], p[4] - p[2]}, p[5]});
  }
  return made;
}

}  // namespace jalon
