// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// One scan laid onto another: the pose, what it is worth, and the moved scan.
// Build:  mcs -r:Jalon.dll 04_register.cs Print.cs
// Run:    mono 04_register.exe reference.las moving.las registered.las
using System;
using Jalon;

static class Register {
  static int Main(string[] args) {
    if (args.Length != 3) {
      Console.Error.WriteLine("usage: register REFERENCE MOVING REGISTERED");
      return 2;
    }
    return Print.Guard(() => {
      using (var reference = Cloud.Read(args[0]))
      using (var moving = Cloud.Read(args[1]))
      using (var registrar = new Registrar("icp"))
      using (var registration = registrar.Run(reference, moving)) {
        PrintPose(registration);
        using (var registered = registration.Apply(moving)) registered.Write(args[2]);
      }
    });
  }

  static void PrintPose(Registration registration) {
    double[,] pose = registration.GetPose();
    for (int i = 0; i < 3; ++i) {
      Console.WriteLine("{0} {1} {2} {3}", Print.Fixed(pose[i, 0], 6), Print.Fixed(pose[i, 1], 6),
                        Print.Fixed(pose[i, 2], 6), Print.Fixed(pose[i, 3], 4));
    }
    using (var summary = registration.GetSummary()) {
      double[] c = summary.Doubles("covariance");  // of rotation and shift, 6 x 6
      Console.WriteLine("{0}, sigma of the shift {1} {2} {3} mm",
                        summary.Doubles("converged")[0] != 0 ? "converged" : "not converged",
                        Print.Fixed(1000 * Math.Sqrt(c[21]), 2), Print.Fixed(1000 * Math.Sqrt(c[28]), 2),
                        Print.Fixed(1000 * Math.Sqrt(c[35]), 2));
    }
  }
}
