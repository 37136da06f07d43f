// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// From a scan to a vector model with openings, for CAD.
// Build:  mcs -r:Jalon.dll 03_model.cs Print.cs
// Run:    mono 03_model.exe scan.las model.dxf
using System;
using Jalon;

static class MakeModel {
  static int Main(string[] args) {
    if (args.Length != 2) {
      Console.Error.WriteLine("usage: model SCAN MODEL");
      return 2;
    }
    return Print.Guard(() => {
      using (var model = ModelOf(args[0])) {
        model.Write(args[1]);
        List(model);
      }
    });
  }

  /// <summary>Planes, then the walls among them with their windows, doors and reveals.</summary>
  static Model ModelOf(string scan) {
    using (var cloud = Cloud.Read(scan))
    using (var segmenter = new Segmenter("ransac"))
    using (var segmentation = segmenter.Run(cloud))
    using (var modeller = new Modeller("facade")) return modeller.Run(cloud, segmentation);
  }

  static void List(Model model) {
    using (var faces = model.GetFaces())
    using (var area = faces["area"]) Console.WriteLine("{0} faces", area.Count);
    using (var parts = model.GetParts()) {
      double[] width = parts.Doubles("width"), height = parts.Doubles("height");
      for (int i = 0; i < width.Length; ++i) {
        ModelPartResult part = model.Part(i);
        if (part.PartClass != "window" && part.PartClass != "door") continue;
        Console.WriteLine("{0}: {1} x {2} m", part.Name, Print.Fixed(width[i], 3), Print.Fixed(height[i], 3));
      }
    }
  }
}
