#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Writes a C program that calls every public function with NULLs and wild values: null_wild.py OUT.c

The functions come from the headers, and what may be NULL from bindings/generator/api_description.py, so a new one is covered
without a change here, or, when a parameter is of a kind that the fixtures below do not have, stops the build with its name.
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bindings", "generator"))
from api_description import (ARRAYS, NOT_NULLABLE, NULLABLE, OPEN, OPERATION, OUTPUTS, SIZED_OUTPUTS,  # noqa: E402
                             TYPED, says)
from headers import public_functions  # noqa: E402

ANY, PASS, FAIL, INVALID = "kAny", "kMustPass", "kMustFail", "kMustBeInvalid"

# Handles: the valid one, and others that are valid too but poor in content.
HANDLES = {
    "jalon_cloud": ("fx_cloud", ["fx_empty", "fx_one", "fx_two", "fx_equal", "fx_collinear", "fx_far", "fx_nan_field"]),
    "jalon_cloud_builder": ("fx_builder", []),
    "jalon_fields": ("fx_fields", []),
    "jalon_model": ("fx_model", ["fx_mesh", "fx_bare"]),
    "jalon_segmenter": ("fx_segmenter", []),
    "jalon_segmentation": ("fx_segmentation", ["fx_no_segments"]),
    "jalon_evaluation": ("fx_evaluation", []),
    "jalon_model_evaluation": ("fx_model_evaluation", []),
    "jalon_modeller": ("fx_modeller", []),
    "jalon_comparer": ("fx_comparer", []),
    "jalon_comparison": ("fx_comparison", []),
    "jalon_registrar": ("fx_registrar", []),
    "jalon_registration": ("fx_registration", []),
    "jalon_scanner": ("fx_scanner", []),
    "jalon_trajectory": ("fx_trajectory", ["fx_bare_trajectory"]),
    "jalon_adjustment": ("fx_adjustment", []),
    "jalon_network": ("fx_network", []),
    "jalon_sections": ("fx_sections", []),
    "jalon_task": ("fx_task", []),
    "jalon_noise_law": ("fx_law", []),
    "jalon_params": ("fx_options(\"normals\")", []),
    "jalon_bytes": ("fx_bytes_of(\"cloud\")", []),
}
# Functions that refuse even the baseline: no part of the fixtures' models is a copy; the registrar is one of
# targets; the table of fields is none of a sweep.
REFUSED = {"jalon_model_remove_copy", "jalon_registrar_run", "jalon_report_write_clearance"}
# Baselines that need another handle or value than the tables give.
BASE = {
    "jalon_gauge_sweep_model.gauge": "fx_block", "jalon_gauge_sweep_model.pose_count": "5",
    "jalon_gauge_sweep.pose_count": "5", "jalon_gauge_sweep.cloud": "fx_small",
    "jalon_gauge_sweep_model.cloud": "fx_small", "jalon_cloud_fit_sphere.cloud": "fx_ball", "jalon_cloud_fit_cylinder.cloud": "fx_ball",
    "jalon_cloud_fit_circle.cloud": "fx_ball", "jalon_segmentation_pick.segmentation": "fx_start",
    "jalon_segmentation_pick.picks": "fx_picks", "jalon_cloud_measure_targets.places": "fx_picks",
    "jalon_segmentation_write_primitives.path": 'fx_path("out.txt")',
    "jalon_noise_law_fit.field": '"deviation"', "jalon_noise_law_from_json.json": r'"{\"law\":\"gauss\",\"mean\":0,\"sigma\":1}"',
    "jalon_cloud_set_field.cloud": "fx_small", "jalon_cloud_set_field.count": "12",
    "jalon_cloud_knn_all.cloud": "fx_small", "jalon_cloud_builder_seal.builder": "fx_builder_ready",
    "jalon_cloud_builder_append_field.name": '"extra"', "jalon_cloud_builder_declare_field.name": '"another"',
    "jalon_cloud_cells.level": "3", "jalon_cloud_cell_neighbours.level": "3",
    "jalon_cloud_crop_polygon.count": "4", "jalon_model_create_mesh.count_triangles": "2",
    "jalon_scene_write_truth.path": 'fx_path("truth.json")', "jalon_scene_write_truth.options": "NULL",
    "jalon_scanner_run.model": "fx_mesh", "jalon_scanner_truth.cloud": "NULL",
    "jalon_cloud_share_octree.count": "3", "jalon_params_set_bool.value": "1", "jalon_cloud_split.value": "1.0",
    "jalon_params_set_doubles.count": "0", "jalon_cloud_crop_polygon.w_min": "-100.0",
    "jalon_cloud_read.path": 'fx_path("scan.las")', "jalon_cloud_write.path": 'fx_path("out.las")',
    "jalon_model_read.path": 'fx_path("model.obj")', "jalon_model_write.path": 'fx_path("out.obj")',
    "jalon_report_write_orthoimage.path": 'fx_path("orthoimage.png")',
    "jalon_report_write_elevation.path": 'fx_path("out.svg")', "jalon_report_write_html.path": 'fx_path("out.html")',
    "jalon_sections_write.path": 'fx_path("sections.dxf")',
    "jalon_cloud_write_depth_map.path": 'fx_path("depth.png")',
    "jalon_report_write_deviations.path": 'fx_path("distances.svg")',
    "jalon_report_write_histogram.path": 'fx_path("histogram.svg")',
    "jalon_report_write_comparison.path": 'fx_path("comparison.html")', "jalon_report_write_comparison.changes": "NULL",
    "jalon_report_write_adjustment.path": 'fx_path("adjustment.html")',
    "jalon_report_write_network.path": 'fx_path("network.html")',
    "jalon_report_write_clearance.path": 'fx_path("clearance.html")', "jalon_report_write_clearance.pose_count": "5",
    "jalon_report_write_registration.path": 'fx_path("registration.html")',
    "jalon_report_write_picture.path": 'fx_path("picture.svg")', "jalon_report_write_json.path": 'fx_path("out.json")', "jalon_params_set_string.value": "fx_text_value",
    "jalon_area_indices.automatic_m2": "fx_areas", "jalon_area_indices.reference_m2": "fx_areas",
    "jalon_area_indices.intersection_m2": "fx_areas",
    "jalon_precision_budget.ranges_m": "fx_ranges", "jalon_precision_budget.vertical_rad": "NULL",
    "jalon_precision_budget.incidence_rad": "NULL", "jalon_angular_precision.ranges_m": "fx_ranges",
    "jalon_trajectory_create.times_s": "fx_ranges", "jalon_trajectory_interpolate.times_s": "fx_ranges",
    "jalon_trajectory_create.position_sigmas_m": "NULL", "jalon_trajectory_create.velocity_sigmas_m_s": "NULL",
    "jalon_trajectory_create.attitude_sigmas_rad": "NULL",
    "jalon_scanner_drive.scanner": "fx_mobile", "jalon_model_perturb_strips.strips": "fx_strips",
    "jalon_trajectory_adjust.trajectory": "fx_driven", "jalon_trajectory_adjust.cloud": "fx_driven_cloud",
    "jalon_trajectory_adjust.model": "fx_driven_strips", "jalon_adjustment_apply.cloud": "fx_driven_cloud",
    "jalon_trajectory_georeference.times_s": "fx_ranges", "jalon_trajectory_georeference.ranges_m": "fx_ranges",
    "jalon_trajectory_read.path": 'fx_path("drive.txt")', "jalon_trajectory_write.path": 'fx_path("driven.txt")',
    "jalon_phase_range.wavelengths_m": "fx_ranges", "jalon_phase_range.remainders_m": "fx_areas",
    "jalon_comparer_use_registration.comparer": "fx_m3c2",
    "jalon_comparison_outlines.forward_points": "fx_changed", "jalon_comparison_outlines.reverse_points": "fx_changed",
    "jalon_comparison_outlines.changes": "NULL",
    "jalon_comparer_run_core.comparer": "fx_m3c2", "jalon_comparer_read_m3c2_file.comparer": "fx_m3c2",
    "jalon_comparer_read_m3c2_file.path": 'fx_path("m3c2.txt")',
    "jalon_cloud_remove_field.name": '"intensity"', "jalon_fields_view.name": '"intensity"',
    "jalon_fields_copy.name": '"intensity"', "jalon_cloud_invert_normals.cloud": "fx_cloud",
}
# Good values that are dear (a gauge that turns within a wall): in one call, not in all calls of the function.
ONCE = {"jalon_gauge_sweep_model.pose_count": ["6"], "jalon_gauge_sweep.pose_count": ["8"]}
TEXTS = ['""', "fx_long_text", r'"\xff\xfe\xc0\x80"', r'"a\nb\r\x1b[2J"', '"%s%n%d%1000000d"', r'"\xf4\x90\x80\x80"']
JSON = ['"{"', '"[]"', '"nul"', r'"{\"k\":1e999}"', r'"{\"no_such_name\":1}"', "fx_deep_json", r'"{\"\xff\":1}"']
PATHS = ['fx_path("")', 'fx_path("no/such/folder/x.las")', 'fx_path("scan.las/below")', 'fx_path("noextension")',
         'fx_path("unknown.extension")']
DOUBLES = ["NAN", "INFINITY", "-INFINITY", "-1.0", "0.0", "1e308", "-1e308", "5e-324"]
COUNT_WILD = ["(uint64_t)1 << 63", "UINT64_MAX", "UINT64_MAX / 24", "(uint64_t)1 << 61"]


class Case:
    """One parameter's values: the baseline and [(label, value, expectation, other parameters' values)]."""

    def __init__(self, base, wild=(), null=None):
        self.base, self.wild, self.null = base, list(wild), null


def null_expectation(function, name):
    if says(NOT_NULLABLE, function.name, name):
        return INVALID
    if says(OPEN, function.name, name):
        return ANY
    return PASS if says(NULLABLE, function.name, name) else INVALID


def wild_values(values_, expectation_=ANY, **others):
    return [(v, v, expectation_, others) for v in values_]


def noun_of_bytes(function):
    """Of jalon_cloud_from_bytes the cloud."""
    return function.name[len("jalon_"):-len("_from_bytes")]


def scalar(function, p):
    """Numbers, by name."""
    n = p.name
    if p.type == "int32_t":
        if n == "type":
            return Case("JALON_FLOAT64", wild_values(["0", "-1", "11", "INT32_MIN", "INT32_MAX"], INVALID)
                        + wild_values([str(i) for i in range(1, 10)]))
        if n == "level":
            return Case("JALON_LEVEL_AUTOMATIC", wild_values(["-2", "22", "INT32_MIN", "INT32_MAX"], INVALID)
                        + wild_values(["0", "1", "21"]))
        if n == "primitive":
            return Case("JALON_PRIMITIVE_PLANE", wild_values(["0", "-1", "4", "INT32_MIN", "INT32_MAX"], INVALID)
                        + wild_values(["JALON_PRIMITIVE_SPHERE", "JALON_PRIMITIVE_CYLINDER"]))
        if n in ("centred", "value"):
            return Case("1", wild_values(["0", "-5", "INT32_MIN"], PASS))
    if p.type == "uint32_t":
        if n == "flags":
            return Case("0", wild_values(["2", "UINT32_MAX"], INVALID) + wild_values(["JALON_CLOUD_DROP_INVALID"], PASS))
        if n == "components":
            others = {"data": "NULL"} if any(q.name == "data" for q in function.parameters) else {}
            return Case("1", wild_values(["0"], INVALID) + wild_values(["UINT32_MAX", "65536"],
                                                                       INVALID if others else ANY, **others))
        if n == "k":
            wild = wild_values(["0", "1000"])
            if any(q.name == "indices" for q in function.parameters):
                wild += wild_values(["UINT32_MAX"], INVALID, indices="NULL")
            else:
                wild += wild_values(["UINT32_MAX"])
            return Case("4", wild)
        if n == "label":
            first = "1" if function.name == "jalon_segmentation_long_edges" else "0"  # 0 is no segment
            return Case(first, wild_values(["UINT32_MAX"]))
        if n == "bins":
            return Case("10", wild_values(["0", "UINT32_MAX"], INVALID))
        if n in ("a", "b", "c"):
            return Case("2", wild_values(["9", "UINT32_MAX"], INVALID) + wild_values(["0", "8"], PASS))
        if n == "threads":
            return Case("2", wild_values(["257", "UINT32_MAX"], INVALID) + wild_values(["0", "1", "256"], PASS))
        if n == "reach":
            return Case("1", wild_values(["0", "1000", "UINT32_MAX"]))
    if p.type == "uint64_t":
        if n in ARRAYS.values():
            datas = [q.name for q in function.parameters if ARRAYS.get(q.name) == n]
            wild = []
            for data in datas:
                wild += wild_values(COUNT_WILD, INVALID, **{data: "NULL"})
            if n == "byte_count":  # cut, or none at all
                return Case('fx_size("%s")' % noun_of_bytes(function), wild + wild_values(["0", "31", "32", "100"], FAIL))
            return Case("8", wild)
        if n == "stride_bytes":
            return Case("0", wild_values(["1", "7", "UINT64_MAX", "(uint64_t)1 << 63"], INVALID))
        if n in ("i", "station"):
            return Case("0", wild_values(["UINT64_MAX", "1000000", "(uint64_t)1 << 63"], INVALID))
        if n in ("part", "other_part"):
            return Case("JALON_WHOLE_MODEL", wild_values(["UINT64_MAX - 1", "(uint64_t)1 << 63"], INVALID)
                        + wild_values(["0", "1"]))
        if n == "bytes":
            return Case("UINT64_MAX", wild_values(["0", "1", "(uint64_t)1 << 63"], PASS))
        if n == "code":
            return Case("0", wild_values(["UINT64_MAX", "(uint64_t)1 << 63", "12345678901"]))
        if n == "seed":
            return Case("1", wild_values(["0", "UINT64_MAX"], PASS if function.name == "jalon_trajectory_perturb" else ANY))
        if n == "capacity_elements":
            return Case("4096", wild_values(["0", "1"], INVALID) + wild_values(["UINT64_MAX"], PASS))
    if p.type == "int64_t" and n == "value":
        return Case("fx_int64_value", wild_values(["INT64_MIN", "INT64_MAX", "-1"]))
    if p.type == "double":
        base = {"value": "fx_double_value", "radius_m": "0.5", "tolerance_m": "1e-4", "w_min": "-100.0",
                "w_max": "100.0", "spacing_s": "10.0"}.get(n)
        refuse = [] if function.name == "jalon_cloud_split" else ["NAN"]
        if n in ("radius_m", "tolerance_m", "spacing_s"):
            refuse += ["-1.0", "-INFINITY"]
        return Case(base, wild_values(refuse, INVALID) + wild_values([d for d in DOUBLES if d not in refuse])) if base else None
    return None


def text(function, p):
    null = null_expectation(function, p.name)
    base = {"crs": '"EPSG:2154"', "name": '"intensity"', "unit": '"m"', "meaning": '"a meaning"', "field": '"intensity"', "other": "NULL", "gradient_field": '"intensity"',
            "label_field": '"intensity"', "class_field": '"intensity"', "reference_field": '"intensity"',
            "part_class": '"wall"', "method": "NULL", "operation": '"normals"', "json": '"{}"', "notes_json": r'"{\"title\":\"t\"}"',
            "value": "fx_text_value", "path": 'fx_path("out.xyz")', "source": 'fx_path("scan.las")', "target": 'fx_path("out.xyz")', "sigma_path": "NULL", "points": r'"id x y z sx sy sz\nA 0 0 0 0 0 0\nB 0 50 0 0 0 0\n"',
            "observations": r'"from to direction zenith distance\nA B 0 100 50\n"'}.get(p.name)
    if base is None:
        return None
    wild = wild_values(TEXTS)
    if p.name == "json":
        wild = wild_values(JSON, FAIL) + wild_values(TEXTS, FAIL)
    if p.name == "notes_json":  # keys it does not know are left aside, an empty text is as good as none
        open_texts = (r'"{\"no_such_name\":1}"', '""')
        wild = wild_values(open_texts) + wild_values([t for t in JSON + TEXTS if t not in open_texts], FAIL)
    if p.name in ("path", "source", "target", "sigma_path"):
        wild = wild_values(TEXTS + PATHS, ANY)
    if p.name in ("method", "operation"):
        wild = wild_values(TEXTS + ['"no such"'], FAIL)
    for part, row in TYPED.items():
        if function.name == "jalon_params_" + part and p.name == "name":
            base = "fx_typed_name[%d]" % row
            wild = wild_values(TEXTS + ['"no such"'], FAIL)
    return Case(base, wild, null)


def pointer_in(function, p):
    null = null_expectation(function, p.name)
    records = {"const jalon_gauge_piece*": "fx_pieces", "const jalon_transform*": "fx_poses",
               "const jalon_target*": "fx_targets"}
    if p.type in records and p.name in ARRAYS:
        return Case(records[p.type], wild_values([records[p.type].replace("fx_", "fx_wild_")], INVALID), INVALID)
    structs = {
        "const jalon_transform*": ("&fx_identity", ["&fx_nan_transform", "&fx_inf_transform"],
                                   ["&fx_zero", "&fx_big_transform"]),
        "const jalon_box*": ("&fx_box", ["&fx_nan_box"], ["&fx_reversed_box"]),
    }
    if p.type in structs:
        base, refused, open_values = structs[p.type]
        return Case(base, wild_values(refused, INVALID) + wild_values(open_values), null)
    if p.type == "const jalon_vec3*":
        return Case("&fx_foot" if p.name == "foot" else "&fx_top",
                    wild_values(["&fx_nan_vec", "&fx_inf_vec"], INVALID) + wild_values(["&fx_foot", "&fx_top"]), null)
    arrays = {"const void*": "fx_xyz", "const double*": "fx_square" if p.name == "polygon_uv" else "fx_xyz",
              "const uint64_t*": "fx_indices", "const uint32_t*": "fx_triangles", "jalon_cloud*const*": "fx_clouds"}
    if p.type in arrays:
        if p.name in ARRAYS:
            return Case(arrays[p.type], [], PASS if function.name == "jalon_params_set_doubles" else INVALID)
        return Case(arrays[p.type], [], null)
    if p.type == "const uint8_t*":
        noun = noun_of_bytes(function)
        other = "params" if noun == "cloud" else "cloud"
        sized = {"byte_count": 'fx_size("%s")' % other}
        return Case('fx_data("%s")' % noun, wild_values(['fx_data("%s")' % other], INVALID, **sized), INVALID)
    callbacks = {"jalon_progress_callback": "fx_progress", "jalon_log_callback": "fx_log"}
    if p.type in callbacks:
        return Case(callbacks[p.type], [], null)
    if p.name == "user":
        return Case("NULL", wild_values(["(void*)(uintptr_t)1"], PASS), null)
    return None


def handle(function, p, first):
    kind = p.type.replace("const ", "").rstrip("*")
    if kind not in HANDLES or p.type.endswith("**") or "*const*" in p.type:
        return None
    base, poor = HANDLES[kind]
    wild = wild_values(poor)
    if kind == "jalon_task" and first:
        base = "fx_task_own"
    if kind == "jalon_params" and p.name == "options":
        operation = OPERATION.get(function.name)
        if operation is None:
            raise SystemExit("%s: which operation do its options belong to? add it to api_description.py" % function.name)
        base = 'fx_options("%s")' % operation
        wild = wild_values(['fx_options("%s")' % ("read" if operation != "read" else "normals")], INVALID)
    for part, row in TYPED.items():
        if function.name == "jalon_params_" + part:
            base = "fx_typed[%d]" % row
    optional = p.name in ("options", "task") and not (first and kind == "jalon_task")
    return Case(base, wild, null_expectation(function, p.name) if not first or optional else INVALID)


def output(function, p, slot):
    if p.name == "user" or not (p.type in OUTPUTS + SIZED_OUTPUTS or (p.type.endswith("**") and p.type[:-2] in HANDLES)):
        return None
    if p.type in SIZED_OUTPUTS:
        size = "(uint32_t)sizeof(%s)" % p.type[:-1]
        return Case("sized_slot(%d, %s)" % (slot, size),
                    [("struct_size " + s, "sized_slot(%d, %s)" % (slot, s), e, {})
                     for s, e in (("0", INVALID), ("3", INVALID), ("UINT32_MAX", INVALID), ("4", PASS), ("8", PASS),
                                  ("4096", PASS))], INVALID)
    return Case("slot(%d)" % slot, [], null_expectation(function, p.name))


def after_success(function, slots):
    """The looks at outputs after a success: (C lines)."""
    lines = []
    for p in function.parameters:
        if p.name not in slots:
            continue
        i = slots[p.name]
        if p.type.endswith("**") and p.type[:-2] in HANDLES:
            kind = p.type[:-2]
            lines.append("SEE_HANDLE(%d, all, %s, %s_release);" % (i, kind, kind))
        elif p.type == "const char**":
            lines.append("see_text(%d, all);" % i)
        elif p.type == "const char*const**":
            lines.append("see_texts(%d, %d, all);" % (i, slots[ARRAYS[p.name]]))
        elif p.type == "jalon_array_view*":
            lines.append("see_view(%d, all);" % i)
    return lines


def c_text(label):
    return '"' + label.replace("\\", "\\\\").replace('"', '\\"') + '"'


def emit(function):
    """The C function that makes all calls of one public function."""
    out, cases, slots = [], {}, {}
    for position, p in enumerate(function.parameters):
        case = handle(function, p, position == 0) or output(function, p, len(slots))
        if case is not None and case.base.startswith(("slot(", "sized_slot(")):
            slots[p.name] = len(slots)
        if case is None:
            case = text(function, p) if p.type == "const char*" else None
        if case is None:
            case = scalar(function, p) or pointer_in(function, p)
        if case is None or case.base is None:
            raise SystemExit("%s: no values for the parameter %s %s: add it to the tables of null_wild.py"
                             % (function.name, p.type, p.name))
        case.base = BASE.get(function.name + "." + p.name, case.base)
        case.wild += wild_values(ONCE.get(function.name + "." + p.name, []), PASS)
        cases[p.name] = case

    def call(changes):
        return "%s(%s)" % (function.name, ", ".join(changes.get(p.name, cases[p.name].base) for p in function.parameters))

    looks = after_success(function, slots)
    after = "NULL"
    if looks:
        after = "after_" + function.name
        out += ["static void %s(int all) {" % after] + ["  " + l for l in looks] + ["}"]
    out += ["static void wild_%s(void) {" % function.name, '  function_begin("%s");' % function.name]
    add = lambda label, expectation, changes: out.append(  # noqa: E731
        "  CASE(%s, %s, %s, %s);" % (c_text(label), expectation, after, call(changes)))
    refused = function.name in REFUSED
    add("valid arguments", FAIL if refused else PASS, {})
    pointers = {p.name: "NULL" for p in function.parameters if cases[p.name].null is not None}
    if pointers:
        strict = any(cases[n].null == INVALID for n in pointers if n != "clouds")  # no clouds at all share what they have
        zeros = {p.name: "0" for p in function.parameters if p.name not in pointers}
        add("all NULL and 0", INVALID if strict else ANY, {**pointers, **zeros})
    for p in function.parameters:
        case = cases[p.name]
        if case.null is not None:
            add("%s = NULL" % p.name, FAIL if refused else case.null, {p.name: "NULL"})
        for label, value, expectation, others in case.wild:
            suffix = "".join(", %s = %s" % item for item in others.items())
            add("%s = %s%s" % (p.name, label, suffix), expectation, {p.name: value, **others})
    out += ["  function_end();", "}"]
    return out


def emit_no_status(function):
    """retain, release, and the texts."""
    name, out = function.name, ["static void wild_%s(void) {" % function.name, '  function_begin("%s");' % function.name]
    if name.endswith("_retain"):
        base = HANDLES[name[:-len("_retain")]][0]
        out += ['  TRUTH("NULL gives NULL", %s(NULL) == NULL);' % name,
                '  TRUTH("gives its argument", %s(%s) == %s);' % (name, base, base)]
    elif name.endswith("_release"):
        base = HANDLES[name[:-len("_release")]][0]
        retain = name[:-len("release")] + "retain"
        out += ['  TRUTH("NULL is fine", (%s(NULL), 1));' % name,
                '  TRUTH("one owner less", (%s(%s), %s(%s), 1));' % (retain, base, name, base)]
    elif function.result == "const char*":
        values = ["0", "-1", "-13", "7", "INT32_MIN", "INT32_MAX"] if function.parameters else [""]
        for v in values:
            out.append('  TRUTH("text for %s", %s(%s) != NULL);' % (v or "nothing", name, v))
    elif function.result == "int32_t" and not function.parameters:
        out.append('  TRUTH("a number", %s() >= 0);' % name)
    else:
        raise SystemExit("%s: a function of an unknown shape; add it to null_wild.py" % name)
    return out + ["  function_end();", "}"]


def main():
    functions = public_functions()
    lines = ["/* Made by tests/abi/null_wild.py; not to be edited. */", '#include "wild_support.h"', ""]
    for function in functions:
        lines += emit(function) if function.result == "jalon_status" else emit_no_status(function)
    lines += ["int main(void) {", "  fx_begin();"] + ["  wild_%s();" % f.name for f in functions]
    lines += ["  fx_end();", "  return wild_report();", "}", ""]
    with open(sys.argv[1], "w", encoding="utf-8") as f:
        f.write("\n".join(lines))


if __name__ == "__main__":
    main()
