#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Writes the C function that makes one drawn call of the public surface: sequences.py OUT.c

Functions and values are those of null_wild.py: each parameter has its good value, and at most one of a call a wild one. Handles are
those that earlier calls made and nobody gave back yet, or the fixtures. sequence_support.c keeps the list of what is alive."""

import sys

from null_wild import BASE, HANDLES, handle, output, pointer_in, scalar, text, public_functions

# Each takes 5 to 300 ms where most calls take less than one: one draw in DEAR_DRAWS of theirs is made, the others are drawn again.
DEAR = {"jalon_cloud_compute_geodesic", "jalon_cloud_compute_map_distance", "jalon_cloud_distance_map", "jalon_cloud_remove_outliers",
        "jalon_model_sample", "jalon_model_volume", "jalon_report_write_clearance", "jalon_report_write_registration",
        "jalon_scanner_run", "jalon_scene_drive_scenario", "jalon_scene_write_truth", "jalon_trajectory_adjust"}
DEAR_DRAWS = 200
NUMBERS = ("uint64_t*", "int64_t*", "int32_t*", "uint32_t*", "double*", "float*", "void*")


def cases_of(function):
    cases, slots = {}, {}
    for position, p in enumerate(function.parameters):
        case = handle(function, p, position == 0) or output(function, p, len(slots))
        if case is not None and case.base.startswith(("slot(", "sized_slot(")):
            slots[p.name] = len(slots)
        if case is None:
            case = text(function, p) if p.type == "const char*" else None
        case = case or scalar(function, p) or pointer_in(function, p)
        case.base = BASE.get(function.name + "." + p.name, case.base)
        cases[p.name] = case
    return cases, slots


def fills_arrays(function):
    """Outputs whose length hangs on the handle: room is there for that of the fixture alone."""
    return any(p.type in NUMBERS and p.name.endswith("s") and not p.type.startswith("const") for p in function.parameters)


def drawn_handle(function, p, base):
    kind = p.type.replace("const ", "").rstrip("*")
    is_fixed = function.name + "." + p.name in BASE or fills_arrays(function) or kind == "jalon_params"
    return base if is_fixed or kind not in HANDLES or p.type.endswith("**") else "drawn_%s(%s)" % (kind, base)


def emit(number, function):
    cases, slots = cases_of(function)
    good = {p.name: drawn_handle(function, p, cases[p.name].base) for p in function.parameters}

    def call(changes):
        return "%s(%s)" % (function.name, ", ".join({**good, **changes}[p.name] for p in function.parameters))

    calls = []
    for p in function.parameters:
        case = cases[p.name]
        if case.null is not None:
            calls.append(call({p.name: "NULL"}))
        calls += [call({p.name: value, **others}) for _, value, _, others in case.wild]
    begin = ["      if (draw(%d) != 0) goto again;" % DEAR_DRAWS] if function.name in DEAR else []
    out = ["    case %d:" % number] + begin + ['      call_begins("%s", %d);' % (function.name, len(slots)),
           "      switch (draw(2) != 0 ? 0 : 1 + draw(%d)) {" % max(1, len(calls))]
    for k, one in enumerate(calls):
        out += ["        case %d:" % (k + 1), "          status = %s;" % one, "          break;"]
    out += ["        default:", "          status = %s;" % call({}), "      }"]
    made = [(slots[p.name], p.type[:-2]) for p in function.parameters
            if p.name in slots and p.type.endswith("**") and p.type[:-2] in HANDLES]
    sized = {slots[p.name] for p in function.parameters if p.name in slots and cases[p.name].base.startswith("sized_slot")}
    out.append("      call_ends(status, %d, %d);" % (len(slots), sum(1 << i for i in sized)))
    out += ["      if (status == JALON_OK) drop_large_cloud(%d);" % slot for slot, kind in made if kind == "jalon_cloud"]
    for slot, kind in made:
        out.append("      if (status == JALON_OK) keep_%s(%d);" % (kind, slot))
    return out + ["      break;"]


def main():
    functions = [f for f in public_functions() if f.result == "jalon_status"]
    if DEAR - {f.name for f in functions}:
        raise SystemExit("tests/abi/sequences.py: there is no " + ", ".join(sorted(DEAR - {f.name for f in functions})))
    lines = ["/* Made by tests/abi/sequences.py; not to be edited. */", '#include "sequence_support.h"', ""]
    for kind in HANDLES:
        lines.append("LIVING(%s)" % kind)
    lines += ["", "void make_drawn_call(void) {", "  jalon_status status;", "again:", "  switch (draw(%d)) {" % (len(functions) + len(HANDLES))]
    for number, function in enumerate(functions):
        lines += emit(number, function)
    for number, kind in enumerate(HANDLES, len(functions)):
        lines += ["    case %d:" % number, "      retain_or_release_%s();" % kind, "      break;"]
    lines += ["  }", "}", "", "void release_the_living(void) {"]
    lines += ["  release_all_%s();" % kind for kind in HANDLES] + ["}", ""]
    with open(sys.argv[1], "w", encoding="utf-8") as f:
        f.write("\n".join(lines))

main()
