# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""A mobile scan and a building model adjusted together: 06_joint.py MODEL CLOUD TRAJECTORY ADJUSTED"""

import sys

import jalon

# Facades are cut into strips, which may bend; roofs come along: they hide what is behind them.
strips = jalon.Model.read(sys.argv[1]).building_strips(others=True, touch_m=2).model
cloud, drive = jalon.Cloud.read(sys.argv[2]), jalon.Trajectory.read(sys.argv[3])
adjustment = drive.adjust(cloud, strips)
summary, controls, blocks = adjustment.summary, adjustment.controls, adjustment.blocks
print("%s, %d points matched, p %.3f"
      % ("converged" if summary["converged"] else "not converged", summary["matched"], summary["p_value"]))
print("start of the drive: %.3f %.3f m, sigma %.3f %.3f m" % (*controls["correction"][0], *controls["sigma"][0]))
for i in range(len(blocks)):
    print("block %d: %.3f %.3f m, sigma %.3f %.3f m" % (i + 1, *blocks["offset"][i], *blocks["sigma"][i]))
adjustment.trajectory.write(sys.argv[4])
