// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cli/inputs/picks.h"

#include <algorithm>

#include "cli/text_file.h"

namespace jalon::cli {

namespace {

struct Pick {
  int32_t primitive = JALON_PRIMITIVE_PLANE;
  std::vector<double> places;
};

Pick parsed(const std::string& text) {
  static constexpr struct {
    const char* name;
    int32_t primitive;
  } kKinds[] = {{"plane:", JALON_PRIMITIVE_PLANE},
                {"sphere:", JALON_PRIMITIVE_SPHERE},
                {"cylinder:", JALON_PRIMITIVE_CYLINDER}};
  Pick pick;
  std::string numbers = text;
  for (const auto& [name, primitive] : kKinds)
    if (text.starts_with(name)) {
      pick.primitive = primitive;
      numbers = text.substr(std::string(name).size());
    }
  size_t end = 0;
  pick.places = leading_numbers(numbers, end);
  if (end != numbers.size() || pick.places.empty() || pick.places.size() % 3 != 0)
    throw Failure{
        JALON_ERROR_INVALID_ARGUMENT,
        "--pick needs X,Y,Z or X,Y,Z;X,Y,Z ..., with \"sphere:\" or \"cylinder:\" before it "
        "for these, not \"" +
            text + "\""};
  return pick;
}

}  // namespace

void Picks::add_to(Command& command) {
  command
      .option(
          "--pick", texts,
          "Grow a segment from here instead of finding all: one place is a seed, three and more "
          "bound a plane; \"sphere:\" or \"cylinder:\" before it for these (repeatable)")
      .type_name("X,Y,Z[;...]")
      .one_each_time();
  settings.add_to(command, "pick-");
}

void Picks::check() const {
  for (const std::string& text : texts) parsed(text);
  if (!are_given() && settings.is_given())
    throw Failure{JALON_ERROR_INVALID_ARGUMENT, "--pick-set and --pick-params are for --pick"};
  settings.apply(make_params("pick").get());
}

Segmentation Picks::grown(const Console& console, const Cloud& cloud) const {
  const Params options = make_params("pick");
  settings.apply(options.get());
  Segmentation made;
  must(jalon_segmentation_start(cloud.get(), console.task(), Out(made)));
  for (const std::string& text : texts) {
    const Pick pick = parsed(text);
    Segmentation more;
    const jalon_status status =
        jalon_segmentation_pick(made.get(), pick.primitive, pick.places.data(),
                                pick.places.size() / 3, options.get(), console.task(), Out(more));
    if (status != JALON_OK)
      throw Failure{status, "--pick " + text + ": " + jalon_last_error_message()};
    made = std::move(more);
  }
  return made;
}

}  // namespace jalon::cli
