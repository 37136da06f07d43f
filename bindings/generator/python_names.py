# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What Python calls the constants and tables of C: enums, and the records that rows of tables are."""

import re

from headers import constants
from shapes import SMALL

# The first constant of an enum of the headers: the class it becomes, the prefix that its members lose.
ENUMS = {
    "CHANGE_APPEARANCE": ("Change", "CHANGE_"), "GAUGE_BOX": ("GaugeKind", "GAUGE_"), "COMPARED": ("PointStatus", ""),
    "EVIDENCE_NONE": ("Evidence", "EVIDENCE_"), "PARAM_DOUBLE": ("ParamType", "PARAM_"), "STOPPED_CONVERGED": ("Stopped", "STOPPED_"),
    "VERDICT_NONE": ("Verdict", "VERDICT_"), "POSE_FROM_FEATURES": ("PoseFrom", "POSE_FROM_"),
    "ORIENTATION_NONE": ("Orientation", "ORIENTATION_"), "RELATION_DISJOINT": ("Relation", "RELATION_"),
    "DIRECTION_LEFT": ("Direction", "DIRECTION_"), "FRONT_NONE": ("FrontSource", "FRONT_"),
    "PRIMITIVE_PLANE": ("Primitive", "PRIMITIVE_"), "OK": ("Status", ""), "TARGET_SPHERE": ("TargetKind", "TARGET_"),
    "RECOGNISED_KNOWN": ("Recognised", "RECOGNISED_"),
    "MATCH_ACCEPTED": ("Match", "MATCH_"), "OBSERVATION_DIRECTION": ("Observation", "OBSERVATION_"),
    "APART_UNKNOWN": ("ApartCause", "APART_"),
    "LOG_DEBUG": ("LogLevel", "LOG_"), "INT8": ("ElementType", ""), "NOT_RECOVERED": ("Recovery", ""),
}
# Parameters that are one of an enum, and fields of the structs of C.
ENUM_INPUTS = {"primitive": "Primitive", "type": "ElementType", "status": "Status"}
ENUM_FIELDS = {("FieldsInfoResult", "type"): "ElementType", ("ParamsInfoResult", "type"): "ParamType"}
# Tables whose rows are records of a class of their own (bindings/python/jalon/_records.py).
RECORDS = {"Segmentation_segments": "Segment", "Model_faces": "Face", "Model_parts": "Part", "Comparison_regions.regions": "Region"}
# Element types of arrays that functions give.
ELEMENTS = {"uint64_t": "uint64", "uint32_t": "uint32", "double": "float64", "float": "float32"}


def enums():
    """({class: [(member, constant, value, comment)]}, [(constant, value, comment)] that stand alone)."""
    groups = {}
    for name, value, comment, group in constants():
        groups.setdefault(group, []).append((name, value, comment))
    classes, alone = {}, []
    for members in groups.values():
        if members[0][0] in ENUMS:
            class_name, prefix = ENUMS[members[0][0]]
            classes[class_name] = [(n[len(prefix):], n, value, comment) for n, value, comment in members]
        elif len(members) > 1 and len({value for _, value, _ in members}) == len(members) and members[0][0] != "OCTREE_MAX_LEVEL":
            raise SystemExit("no class for the constants %s ...: add a line to bindings/generator/python_names.py" % members[0][0])
        else:
            alone += members
    return classes, alone


def columns_of_enums(doc):
    """{column: enum class} of the tables in a comment: what says JALON_ORIENTATION_... or JALON_COMPARED ..."""
    by_prefix = {prefix.rstrip("_"): name for name, prefix in ENUMS.values() if prefix}
    by_first = {first: name for first, (name, _) in ENUMS.items()}
    found = {}
    for column, constant, dots in re.findall(r"^ +([a-z]\w*) +u?int\d+ .*?JALON_([A-Z0-9_]+)( ?\.\.\.)?", doc, re.M):
        name = by_first.get(constant) or (by_prefix.get(constant.rstrip("_")) if dots else None)
        if name is not None:
            found[column] = name
    return found


def is_single(m, o):
    """Whether the comment says that this table has one row: a summary."""
    one = r"[Oo]ne\s+row(?! an?\b| from| each)"
    if len(m.outputs) == 1:
        return bool(re.search(one, m.doc))
    return bool(re.search(r"\b%s(?: of both)?[,:] %s" % (re.escape(o.name), one.replace("[Oo]", "o")), m.doc))


def is_table(o):
    return o is not None and o.kind == "handle" and o.type == "jalon_fields"


def dtype_of(m, o):
    """The element type of an array that a function gives, where it is always the same."""
    if o.kind == "filled":
        return ELEMENTS[o.type[0]]
    if o.kind in ("doubles", "small") or m.full_name == "Cloud_points":
        return "float64"
    return None


def shape_of(o):
    return o.type if isinstance(o.type, tuple) else SMALL[o.type]


def is_pose(o):
    return o is not None and o.kind == "small" and o.type == "jalon_transform"
