#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""The view in three dimensions of every report, in Chromium: check.py BUILD_FOLDER [FOLDER_FOR_PICTURES]

No error and no request on any page; three known points at the pixels where a camera computed here puts them; what clicks,
keys, sections and links do; one line where there is no WebGL or no script. Without Chromium skipped (77), visibly."""

import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from chromium import Chromium

MOST_BYTES_OF_2M = 8e6
LENS = 1 / math.tan(0.4)  # of viewer.js
PATCHES = {"red": ((2.0, 1.0, 0.5), (255, 0, 0)), "green": ((-3.0, 2.0, 0.0), (0, 255, 0)),
           "blue": ((1.0, -2.0, 1.0), (0, 0, 255))}
ORIGIN = (652000.0, 6861000.0, 100.0)


class Tally:
    passed = failed = 0

    def case(self, name, good, why=""):
        self.passed, self.failed = self.passed + bool(good), self.failed + (not good)
        print("%s - %s%s" % ("ok" if good else "not ok", name, "" if good or why == "" else ": %s" % (why,)))


def jalon(tool, *arguments):
    subprocess.run([tool, arguments[0], "--quiet", *map(str, arguments[1:])], check=True, stdout=subprocess.DEVNULL)


def make_pages(tool, work):
    """One report of each kind, and one of 2 M points."""
    jalon(tool, "scan", "--scene", "facade", "-o", work / "facade.las")
    jalon(tool, "scan", "--scene", "facade", "--set", "seed=5", "--scene-set", "rotation_rad=0.05", "-o", work / "moved.las")
    jalon(tool, "facade", "--viewer-points", 150000, work / "facade.las", "-o", work / "facade")
    jalon(tool, "segment", "--viewer-points", 150000, work / "facade.las", "-o", work / "segments")
    jalon(tool, "register", "--viewer-points", 150000, work / "facade.las", work / "moved.las", "-o", work / "registration",
          "--force")
    for day in (1, 4):
        jalon(tool, "scan", "--scene", "earthworks", "--scene-set", "day=%d" % day, "--method", "sample", "--set",
              "points=100000", "--set", "seed=%d" % day, "-o", work / ("day%d.las" % day))
    jalon(tool, "compare", "--viewer-points", 150000, work / "day1.las", work / "day4.las", "-o", work / "comparison")
    jalon(tool, "scan", "--method", "mobile", "-o", work / "drive.ply", "--model", work / "street.obj", "--trajectory",
          work / "drive.txt", "--scene-set", "sigma_position_m=1", "--scene-set", "leg_m=60")
    jalon(tool, "adjust", "--viewer-points", 20000, work / "street.obj", work / "drive.ply", work / "drive.txt", "-o",
          work / "adjustment", "--strips-set", "touch_m=2")
    jalon(tool, "scan", "--scene", "yard", "--method", "sample", "--set", "spacing_m=0.1", "--set", "densities=target=16", "-o",
          work / "yard.las")
    jalon(tool, "code", "--method", "survey", "--viewer-points", 100000, work / "yard.las", work / "yard.survey.txt", "-o",
          work / "coded")
    make_tunnel(work)
    jalon(tool, "clearance", "--viewer-points", 20000, work / "tunnel.xyz", "--gauge", work / "gauge.json", "--trajectory",
          work / "track.txt", "-o", work / "clearance")
    jalon(tool, "scan", "--scene", "facade", "--method", "sample", "--set", "points=2100000", "-o", work / "large.las")
    jalon(tool, "segment", "--viewer-points", 2000000, work / "large.las", "-o", work / "large")


def make_tunnel(work):
    """A tunnel of radius 3 m about the x axis with a bulge, a gauge of two boxes and its way through."""
    with open(work / "tunnel.xyz", "w") as file:
        for i in range(401):
            for k in range(60):
                radius = 2.0 if (i, k) == (200, 5) else 3.0
                file.write("%.9f %.9f %.9f\n" % (0.1 * i, radius * math.cos(k * math.pi / 30), radius * math.sin(k * math.pi / 30)))
    (work / "track.txt").write_text("x y z\n" + "".join("%d 0 0\n" % x for x in (2, 12, 22, 32)))
    (work / "gauge.json").write_text('{"pieces": [{"type": "box", "size": [2, 3.6, 2.4]}, {"type": "box", "size": [1, 2, 3.4]}]}')


def make_patches(tool, work):
    """A grey floor with three coloured patches at known places, on a national grid."""
    with open(work / "a.txt", "w") as a, open(work / "b.txt", "w") as b:
        for file in (a, b):
            file.write("x y z red green blue\n")

        def put(p, rgb):
            x, y, z = (v + o for v, o in zip(p, ORIGIN))
            a.write("%.4f %.4f %.4f %d %d %d\n" % (x, y, z, *rgb))
            b.write("%.4f %.4f %.4f %d %d %d\n" % (x, y, z + 0.01, *rgb))

        for i in range(-80, 81):
            for k in range(-80, 81):
                put((i * 0.05, k * 0.05, -0.5), (128, 128, 128))
        for place, rgb in PATCHES.values():
            for i in range(-10, 11):
                for k in range(-10, 11):
                    for z in (-0.01, 0.0, 0.01):
                        put((place[0] + 0.01 * i, place[1] + 0.01 * k, place[2] + z), rgb)
    jalon(tool, "compare", "--method", "distance", "--set", "detection=false", work / "b.txt",
          work / "a.txt", "-o", work / "patches")


def project(eye, place, origin, width, height):
    """The pixel of a place by a camera of its own: turned by azimuth and elevation about `at`, `far` away."""
    c = math.cos(eye["el"])
    back = (math.cos(eye["az"]) * c, math.sin(eye["az"]) * c, math.sin(eye["el"]))
    right = (-math.sin(eye["az"]), math.cos(eye["az"]), 0)
    up = (back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2],
          back[0] * right[1] - back[1] * right[0])
    d = [p - o - a for p, o, a in zip(place, origin, eye["at"])]
    x, y, depth = (sum(u * v for u, v in zip(axis, d)) for axis in (right, up, back))
    scale = LENS * height / 2 / (eye["far"] if eye["flat"] else eye["far"] - depth)
    return width / 2 + x * scale, height / 2 - y * scale


def ready(page, path, fragment=""):
    page.open(path, fragment)
    return page.wait("!!window.jalonView || "
                     "!!(document.getElementById('view-told') || {textContent: ''}).textContent.includes('WebGL')")


def quiet(page, tally, name):
    own = [r for r in page.requests if not r.startswith("file:") and not r.startswith("data:image/png")]
    tally.case(name + ": no error", not page.errors, page.errors[:3])
    tally.case(name + ": no request", not own, own[:3])


def box(page):
    page.value("document.getElementById('view-box').scrollIntoView()")
    return page.value("(b => [b.left, b.top, b.width, b.height])(document.getElementById('view-gl').getBoundingClientRect())")


# Is the frame of the picture white all around?
WHITE_FRAME = """(() => {
  const {width, height} = document.getElementById("view-gl");
  for (let t = 0; t < 1; t += 1 / 256)
    for (const [x, y] of [[t * width, 1], [t * width, height - 2], [1, t * height], [width - 2, t * height]])
      if (Math.min(...jalonView.pixel(x, y)) < 255) return false;
  return true;
})()"""


def looked_at(page, tally, work, pictures):
    for name, points in (("facade", 150000), ("segments", 150000), ("comparison", 150000), ("registration", 150000),
                         ("adjustment", 20000), ("coded", 100000), ("clearance", 20000), ("large", 2000000)):
        tally.case(name + ": the view comes", ready(page, work / name / "report.html"))
        shown = page.value("jalonView.points")
        tally.case(name + ": has the points asked for", abs(shown - points) <= 3 or name == "adjustment" and 0 < shown <= points, shown)
        quiet(page, tally, name)
        if name in ("facade", "segments", "comparison", "registration"):
            tally.case(name + ": nothing is cut off by the frame", page.value(WHITE_FRAME))
        if name == "large":
            size = os.path.getsize(work / name / "report.html")
            print("FIGURE viewer 2 M points: %.2f MB, decoded in %.0f ms, first picture after %.0f ms (no graphics card)"
                  % (size / 1e6, page.value("jalonView.decoded"), page.value("jalonView.ms")))
            tally.case("2 M points take at most 8 MB", size <= MOST_BYTES_OF_2M, size)
        if pictures:
            box(page)
            page.picture(os.path.join(pictures, name + ".png"))


def known_points(page, tally, work):
    ready(page, work / "patches" / "report.html")
    page.value("jalonView.set({mode: 'colour', names: 0})")
    width, height = page.value("[document.getElementById('view-gl').width, document.getElementById('view-gl').height]")
    origin = page.value("JSON.parse(document.getElementById('view-scene').textContent).origin")
    for flat, az, el in ((0, -1.2, 0.4), (0, 0.7, 1.2), (1, -2.0, 0.8)):
        page.value("jalonView.set({flat: %d, az: %g, el: %g})" % (flat, az, el))
        eye = page.value("jalonView.eye()")
        for name, (place, rgb) in PATCHES.items():
            x, y = project(eye, [p + o for p, o in zip(place, ORIGIN)], origin, width, height)
            seen = page.value("jalonView.pixel(%f, %f)" % (x, y))[:3]
            tally.case("the %s patch is at its pixel, seen from %g, %g%s" % (name, az, el, ", parallel" if flat else ""),
                       max(abs(a - b) for a, b in zip(seen, rgb)) <= 2, seen)
    # A section about the height of the floor takes the patches away.
    page.value("jalonView.set({flat: 1, az: -1.57, el: 1.57, cut: 3, pos: 0, wide: 0.05})")
    eye = page.value("jalonView.eye()")
    for name, (place, rgb) in PATCHES.items():
        x, y = project(eye, [p + o for p, o in zip(place, ORIGIN)], origin, width, height)
        seen = page.value("jalonView.pixel(%f, %f)" % (x, y))[:3]
        tally.case("a section below the %s patch hides it" % name, max(seen) - min(seen) < 3, seen)
    quiet(page, tally, "patches")


def hand(page, tally, work):
    path = work / "facade" / "report.html"
    ready(page, path)
    left, top, width, height = box(page)
    scene = "JSON.parse(document.getElementById('view-scene').textContent)"
    window = page.value("(s => s.parts.find(p => p.kind == 'opening' && p.tag[0] == 'W').rings[0].map((v, i) =>"
                        " v + s.origin[i %% 3]))(%s)" % scene)
    middle = [sum(window[k::3]) / (len(window) / 3) for k in range(3)]
    x, y, _ = page.value("jalonView.project(%s)" % middle)
    page.click(left + x, top + y)
    told = page.value("document.getElementById('view-told').textContent")
    tally.case("a click on a window tells its type and sizes", told.startswith("W") and "width" in told, told)
    page.click(left + width * 0.45, top + height * 0.5)
    told = page.value("document.getElementById('view-told').textContent")
    tally.case("a second click tells the distance", " distance " in told, told)
    page.value("document.getElementById('view-gl').focus()")
    before = page.value("jalonView.eye()")
    for key, changed in (("ArrowLeft", "az"), ("+", "far"), ("p", "flat"), ("m", "mode"), ("x", "cut"), ("n", "names")):
        page.press(key)
        after = page.value("jalonView.eye()")
        tally.case("the key %s changes %s" % (key, changed), after[changed] != before[changed], after)
    page.press("Escape")
    tally.case("Escape tells the keys", "Keys" in page.value("document.getElementById('view-told').textContent"))
    tally.case("the view is in the link", page.wait("location.hash.startsWith('#view=')", 20))
    eye, fragment = page.value("jalonView.eye()"), page.value("location.hash")
    ready(page, path, fragment)
    again = page.value("jalonView.eye()")
    same = all(abs(again[k] - eye[k]) < 1e-3 for k in ("az", "el", "far", "cut", "flat")) and again["mode"] == eye["mode"]
    tally.case("the link brings the view back", same, again)
    page.call("Emulation.setEmulatedMedia", media="print")
    shown = page.value("getComputedStyle(document.querySelector('section.view')).display")
    tally.case("the view is not printed", shown == "none", shown)
    page.call("Emulation.setEmulatedMedia", media="")
    quiet(page, tally, "clicks and keys")
    page.call("Emulation.setScriptExecutionDisabled", value=True)
    page.open(path)
    tally.case("without script a line says so", page.wait(
        "!!document.querySelector('noscript') && document.querySelector('noscript').innerText.includes('needs JavaScript')", 20))
    page.call("Emulation.setScriptExecutionDisabled", value=False)


def without_webgl(program, tally, work):
    page = Chromium(program, "--disable-3d-apis")
    ready(page, work / "facade" / "report.html")
    told = page.value("document.getElementById('view-told').textContent")
    tally.case("without WebGL one line stands there", "no WebGL 2" in told, told)
    tally.case("and no picture", page.value("!document.getElementById('view-box')"))
    page.close()


def main():
    program = shutil.which("chromium")
    if program is None:
        print("skipped: chromium is not installed\n0 passed, 0 failed, 1 skipped")
        return 77
    tool, pictures = os.path.join(sys.argv[1], "src", "jalon"), sys.argv[2] if len(sys.argv) > 2 else None
    tally = Tally()
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        make_pages(tool, work)
        make_patches(tool, work)
        page = Chromium(program)
        try:
            looked_at(page, tally, work, pictures)
            known_points(page, tally, work)
            hand(page, tally, work)
        finally:
            page.close()
        without_webgl(program, tally, work)
    print("%d passed, %d failed, 0 skipped" % (tally.passed, tally.failed))
    return 1 if tally.failed else 0


if __name__ == "__main__":
    sys.exit(main())
