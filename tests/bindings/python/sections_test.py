# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import os
import tempfile
import unittest

import numpy as np

import jalon

RADIUS = 3.0


def tunnel():
    rng = np.random.default_rng(7)
    turn = rng.random(200000) * 2 * np.pi
    r = RADIUS + 0.003 * rng.standard_normal(turn.size)
    return jalon.Cloud(np.c_[652000 + r * np.cos(turn), 6861000 + 20 * rng.random(turn.size), 100 + r * np.sin(turn)])


class CloudSections(unittest.TestCase):
    def python__cross_sections_of_a_tunnel_are_its_circle(self):
        axis = [[652000, 6861000, 0], [652000, 6861020, 0]]
        sections = tunnel().sections(axis, step_m=5, thickness_m=0.2, gap_m=0.5)
        self.assertEqual([sections.name(i) for i in range(5)], ["STATION %d.000" % s for s in (0, 5, 10, 15, 20)])
        self.assertTrue((sections.lines["closed"] == 1).all())
        np.testing.assert_allclose(sections.summary["at"], [0, 5, 10, 15, 20])
        np.testing.assert_allclose(sections.summary["length"], 2 * np.pi * RADIUS, rtol=0.01)
        uv = sections.vertices["uv"]
        off = np.hypot(uv[:, 0], uv[:, 1] - 100) - RADIUS
        self.assertLess(abs(off).max(), 0.02 + 0.003)
        self.assertIn('"step_m"', sections.parameters)

    def python__sections_are_written_by_the_end_of_their_name(self):
        sections = tunnel().sections(at_m=[99, 101])
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.dxf", "a.svg"):
                sections.write(os.path.join(folder, name))
                self.assertGreater(os.path.getsize(os.path.join(folder, name)), 1000)
            with self.assertRaises(jalon.UnsupportedError):
                sections.write(os.path.join(folder, "a.pdf"))


if __name__ == "__main__":
    unittest.main()
