// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// A mobile scan and a building model, each wrong in its own way, brought into agreement by their standard deviations.
// Build:  mcs -r:Jalon.dll 06_joint.cs Print.cs
// Run:    mono 06_joint.exe street.obj drive.ply drive.txt adjusted.txt
using System;
using Jalon;

static class Joint {
  static int Main(string[] args) {
    if (args.Length != 4) {
      Console.Error.WriteLine("usage: joint MODEL CLOUD TRAJECTORY ADJUSTED");
      return 2;
    }
    // Facades are cut into strips, which may bend; roofs come along: they hide what is behind them.
    return Print.Guard(() => {
      using (var buildings = Model.Read(args[0]))
      using (var options = new BuildingStripsOptions { Others = true, TouchM = 2 })
      using (var strips = buildings.BuildingStrips(options))
      using (var cloud = Cloud.Read(args[1]))
      using (var drive = Trajectory.Read(args[2]))
      using (var adjustment = drive.Adjust(cloud, strips.Model))
      using (var adjusted = adjustment.GetTrajectory()) {
        Tell(adjustment);
        adjusted.Write(args[3]);
      }
    });
  }

  static void Tell(Adjustment adjustment) {
    using (var summary = adjustment.GetSummary())
    using (var controls = adjustment.GetControls())
    using (var blocks = adjustment.GetBlocks()) {
      Console.WriteLine("{0}, {1} points matched, p {2}",
                        summary.Doubles("converged")[0] != 0 ? "converged" : "not converged",
                        (long)summary.Doubles("matched")[0], Print.Fixed(summary.Doubles("p_value")[0], 3));
      Say("start of the drive", controls.Doubles("correction"), controls.Doubles("sigma"), 0);
      double[] offset = blocks.Doubles("offset"), sigma = blocks.Doubles("sigma");
      for (int i = 0; i < offset.Length / 2; ++i) Say("block " + (i + 1), offset, sigma, i);
    }
  }

  static void Say(string what, double[] by, double[] sigma, int row) {
    Console.WriteLine("{0}: {1} {2} m, sigma {3} {4} m", what, Print.Fixed(by[2 * row], 3), Print.Fixed(by[2 * row + 1], 3),
                      Print.Fixed(sigma[2 * row], 3), Print.Fixed(sigma[2 * row + 1], 3));
  }
}
