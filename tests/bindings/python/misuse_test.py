# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Drawn misuse of every public member: what is wrong for its kind, and objects that are closed. JALON_FULL=1: twenty times as much."""

import collections
import gc
import os
import random
import tempfile
import unittest

import numpy as np

import jalon
from lifetimes_test import collect
from network_test import NAILS, sights
from pickling_test import objects
from trajectories_test import bent_drive
import misuse

MISUSES = 20000 if "JALON_FULL" in os.environ else 1000
SEED = 24
REFUSED = (jalon.Error, TypeError, ValueError, LookupError, OverflowError)  # and nothing else; setting may tell of an attribute


def every_kind():
    """An object of each class that can be had in no time."""
    made = objects()
    targets, gauge = jalon.Targets({"a": (1, 2, 3)}), jalon.Gauge()
    gauge.add_sphere(0.5)
    more = [jalon.Task(), jalon.CloudBuilder(), jalon.Network.adjust(sights(), NAILS, refraction=1), bent_drive(),
            made["Cloud"].sections(direction=[0, 0, 1], at_m=[0.5])]
    made.update({type(o).__name__: o for o in more})
    return made, {"Targets": targets, "Gauge": gauge}


class Misuse(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.open, cls.lists = every_kind()
        cls.closed, _ = every_kind()
        for made in cls.closed.values():
            made.close()
        cls.folder = tempfile.TemporaryDirectory()
        cls.plausible = {"int": 1, "float": 0.5, "bool": True, "str": "any f8", "Path": os.path.join(cls.folder.name, "out.las"),
                         "ArrayLike": np.eye(4)[:, :3], "ValuesLike": [0.1, 0.2, 0.3], "Indices": [0, 1, 2], "Bytes": b"bytes",
                         "CrsLike": "EPSG:2154", "TargetsLike": cls.lists["Targets"], "Gauge": cls.lists["Gauge"],
                         "Iterable[Cloud]": [cls.open["Cloud"]], "Union[ElementType, int]": jalon.FLOAT64,
                         "Union[Primitive, int]": jalon.PRIMITIVE_PLANE, "Union[Status, int]": 0}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def arguments(self, member):
        """Some value for each parameter that must be given."""
        return {p.name: self.open.get(p.kind, self.plausible.get(p.kind)) for p in member.parameters if p.required}

    def draw(self, draw, member):
        """(what is wrong, a call that must raise), or None."""
        target = jalon if member.owner is None else getattr(jalon, member.owner)
        known = member.owner in self.open
        if not member.is_static and not known or member.manner != "call" and draw.random() < 0.7:
            return None  # the many properties are not most of it
        values = self.arguments(member)
        if not member.is_static and draw.random() < 0.2:
            subject = self.closed[member.owner]
            if member.manner == "call":
                return "closed self", lambda: getattr(subject, member.name)(**values)
            return "closed self", lambda: getattr(subject, member.name)
        choices = [(p, wrong) for p in member.parameters for wrong in misuse.wrong_values(p, self.closed)]
        if not choices:
            return None
        parameter, wrong = draw.choice(choices)
        what = "closed argument" if hasattr(wrong, "close") and getattr(wrong, "closed", False) else "wrong " + parameter.kind
        if not member.is_static:
            target = self.open[member.owner]
        if member.manner == "set":
            return what + " set", lambda: setattr(target, member.name, wrong)
        if draw.random() < 0.05:
            parameter, wrong, what = misuse.UNKNOWN, 1, "unknown keyword"
        values[parameter.name] = wrong
        function = target if member.name == "__init__" else getattr(target, member.name)
        return what, lambda: function(**values)

    def python__a_thousand_misuses_of_drawn_members_raise(self):
        draw, kinds, seen = random.Random(SEED), collections.Counter(), set()
        members, wrong = misuse.members(), []
        self.assertGreater(len(members), 250)
        before = {name: made.to_bytes() for name, made in self.open.items() if hasattr(made, "to_bytes")}
        gc.collect()
        handles = jalon._live_handle_count()
        while sum(kinds.values()) < MISUSES:
            member = draw.choice(members)
            drawn = self.draw(draw, member)
            if drawn is None:
                continue
            what, call = drawn
            name = "%s.%s" % (member.owner, member.name)
            try:
                call()
                wrong.append("%s took %s: %s" % (name, what, [c.cell_contents for c in call.__closure__]))
            except (*REFUSED, *[AttributeError] * (member.manner == "set")) as error:
                if not str(error) or isinstance(error, jalon.InternalError):
                    wrong.append("%s, %s: %r" % (name, what, error))
            except BaseException as error:  # whatever else it is, it is none that a host expects
                wrong.append("%s, %s: %r" % (name, what, error))
            kinds["closed" if what.startswith("closed") else what] += 1
            seen.add(name)
        self.assertEqual(wrong, [])
        collect(handles)
        self.assertEqual(jalon._live_handle_count(), handles)
        for name, bytes_before in before.items():
            self.assertEqual(self.open[name].to_bytes(), bytes_before, name)
        self.assertEqual(os.listdir(self.folder.name), [])
        print("FIGURE misuses of Python: %d of %d members raised (%s)" % (
            sum(kinds.values()), len(seen), ", ".join("%d %s" % (n, k) for k, n in kinds.most_common())))
