// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// What has changed between two scans: distances, then connected regions of changed points.
// Build:  mcs -r:Jalon.dll 05_changes.cs Print.cs
// Run:    mono 05_changes.exe before.las after.las
using System;
using Jalon;

static class Changes {
  static int Main(string[] args) {
    if (args.Length != 2) {
      Console.Error.WriteLine("usage: changes BEFORE AFTER");
      return 2;
    }
    return Print.Guard(() => {
      using (var before = Cloud.Read(args[0]))
      using (var after = Cloud.Read(args[1]))
      using (var comparer = new Comparer("distance") { LocalModel = "plane", MaxDistanceM = 2 })
      using (var comparison = comparer.Run(before, after)) ListRegions(comparison);
    });
  }

  static void ListRegions(Comparison comparison) {
    using (var options = new RegionsOptions { Criterion = "threshold", ThresholdM = 0.1, MinPoints = 50 })
    using (var result = comparison.Regions(options)) {
      Fields regions = result.Regions;
      double[] area = regions.Doubles("area"), mean = regions.Doubles("mean");
      using (var points = regions["points"]) {
        for (int i = 0; i < points.Count; ++i) {
          Console.WriteLine("region {0}: {1} points, {2} m2, mean {3} m", i + 1, points[i], Print.Fixed(area[i], 3),
                            Print.Fixed(mean[i], 3));
        }
      }
    }
  }
}
