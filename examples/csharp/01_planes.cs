// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// Planes of a scan. Build:  mcs -r:Jalon.dll 01_planes.cs Print.cs
// Run:  mono 01_planes.exe scan.las
using System;
using Jalon;

static class Planes {
  static int Main(string[] args) {
    if (args.Length != 1) {
      Console.Error.WriteLine("usage: planes SCAN");
      return 2;
    }
    return Print.Guard(() => List(args[0]));
  }

  static void List(string scan) {
    using (var cloud = Cloud.Read(scan))                // points, fields, stations
    using (var segmenter = new Segmenter())             // a worker: parameters, no data
    using (var segmentation = segmenter.Run(cloud))     // what it produces: immutable, keeps the cloud
    using (var segments = segmentation.GetSegments()) { // a table: one row a plane
      double[] area = segments.Doubles("area"), sigma = segments.Doubles("sigma");
      for (int i = 0; i < area.Length; ++i) {
        Console.WriteLine("plane {0,2}: {1,7} m2, sigma {2} mm", i + 1, Print.Fixed(area[i], 2),
                          Print.Fixed(1000 * sigma[i], 1));
      }
    }
  }
}
