# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""A scanned facade as a model for CAD, with its windows and doors: 03_model.py SCAN MODEL"""

import sys

import jalon

cloud = jalon.Cloud.read(sys.argv[1])
segmentation = jalon.Segmenter("ransac").run(cloud)
model = jalon.Modeller("facade").run(cloud, segmentation)
model.write(sys.argv[2])
print("%d faces" % len(model.faces))
parts = model.parts
for i in range(model.part_count):
    part = model.part(i)
    if part.part_class in ("window", "door"):
        print("%s: %.3f x %.3f m" % (part.name, parts["width"][i], parts["height"][i]))
