# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Points of a scan classified by the codes of a survey: 07_feature_codes.py SCAN CODES CLASSIFIED MODEL"""

import sys

import jalon

# A line a point: ID;X;Y;Z;code.
with open(sys.argv[2], encoding="utf-8") as file:
    codes = file.read()
cloud = jalon.Cloud.read(sys.argv[1])
coded = jalon.Segmenter("survey_codes", codes=codes).run(cloud)
# Every object is a segment; its source label is its number in the list.
segments = coded.segments
for i in range(len(segments)):
    print("object %d: %d points" % (segments["source_label"][i], segments["inliers"][i]))
coded.cloud.write(sys.argv[3])
model = jalon.Modeller("coded_objects").run(cloud, coded)
for i in range(model.part_count):
    part = model.part(i)
    print("%s: %s" % (part.part_class, part.name))
model.write(sys.argv[4])
