# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""One scan laid onto another, and what the pose is worth: 04_register.py REFERENCE MOVING REGISTERED"""

import math
import sys

import jalon

reference, moving = jalon.Cloud.read(sys.argv[1]), jalon.Cloud.read(sys.argv[2])
registration = jalon.Registrar("icp").run(reference, moving)
for row in registration.pose[:3]:
    print("%.6f %.6f %.6f %.4f" % tuple(row))
summary = registration.summary.to_dict()
sigmas = [1000 * math.sqrt(summary["covariance"][7 * i]) for i in (3, 4, 5)]  # of rotation and shift, 6 x 6
state = "converged" if summary["converged"] else "not converged"
print(state + ", sigma of the shift %.2f %.2f %.2f mm" % tuple(sigmas))
registration.apply(moving).write(sys.argv[3])
