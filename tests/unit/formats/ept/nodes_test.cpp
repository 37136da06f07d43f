// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/nodes.h"

#include "unit/formats/ept/ept_files.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Failure refusal(const EptFolder& set) {
  return failure_of([&] { read(set.path()); });
}

}  // namespace

TEST_CASE("ept_nodes__hierarchies_that_lie_are_refused_with_their_file") {
  const Cloud cloud = wall_and_ground(100, 51);
  struct Lie {
    const char *text, *words;
  };
  const Lie lies[] = {{"{\"0-0-0-0\":99}", "points"},
                      {"{\"0-0-0-0\":100000000000000}", "points"},
                      {"{\"0-0-0-0\":-2}", "no node"},
                      {"{\"0-0-0-0\":1.5}", "whole number"},
                      {"{\"0-0-0-0\":100,\"0-0-0-0\":100}", "twice"},
                      {"{\"0-0-0-0\":-1}", "its own file"},
                      {"{\"0-0-0-0\":100,\"1-2-0-0\":1}", "no node"},
                      {"{\"0-0-0-0\":100,\"1-0-0-0/../../x\":1}", "no node"},
                      {"{\"0-0-0-0\":100,\"99-0-0-0\":1}", "no node"},
                      {"{\"0-0-0-0\":100,\"1--1-0-0\":1}", "no node"},
                      {"{\"0-0-0-0\":100,\"1-0-0-00\":1}", "no node"},
                      {"{\"0-0-0-0\":100,\"1--0-0-0\":1}", "no node"},
                      {"{\"0-0-0-0\":100,\"a\\nb\":1}", "no node"},
                      {"[1]", "an object"},
                      {"nonsense", "an object"},
                      {"{\"0-0-0-0\":100}x", "offset 15"}};
  for (const Lie& lie : lies) {
    CAPTURE(lie.text);
    const EptFolder set(cloud);
    spill(set.file(kRootHierarchy), lie.text);
    const Failure failure = refusal(set);
    CHECK(failure.status == Status::kFormat);
    CHECK_MESSAGE(has_text(failure.text, lie.words), failure.text);
    CHECK(has_text(failure.text, "ept-"));
    CHECK(!has_text(failure.text, "\n"));
  }
}

TEST_CASE("ept_nodes__files_below_are_followed_once_and_only_where_they_are_wanted") {
  const EptFolder set(wall_and_ground(100, 52));
  spill(set.file(kRootHierarchy), "{\"0-0-0-0\":100,\"1-0-0-0\":-1}");
  CHECK(refusal(set).status == Status::kNotFound);  // no such file
  ReadSettings coarse;
  coarse.spacing_m = 1000;
  CHECK(read(set.path(), coarse).size() == 100);
  spill(set.file("ept-hierarchy/1-0-0-0.json"), "{\"1-0-0-0\":2,\"2-0-0-0\":0}");
  spill(set.file("ept-data/1-0-0-0.bin"), slurp(set.file("ept-data/0-0-0-0.bin")).substr(0, 32));
  CHECK(read(set.path()).size() == 102);
  spill(set.file("ept-hierarchy/1-0-0-0.json"), "{\"1-0-0-0\":2,\"2-0-0-0\":-1}");
  spill(set.file("ept-hierarchy/2-0-0-0.json"), "{\"1-0-0-0\":-1}");
  const Failure failure = refusal(set);
  CHECK(failure.status == Status::kFormat);
  CHECK(has_text(failure.text, "comes twice"));
}
