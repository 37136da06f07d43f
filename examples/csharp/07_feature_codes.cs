// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// What a surveyor coded in the field, "ID;X;Y;Z;code" a line, gives the points of a scan their classes and objects, and
// makes a model of them.
// Build:  mcs -r:Jalon.dll 07_feature_codes.cs Print.cs
// Run:    mono 07_feature_codes.exe scan.las codes.txt classified.las objects.dxf
using System;
using System.IO;
using Jalon;

static class FeatureCodes {
  static int Main(string[] args) {
    if (args.Length != 4) {
      Console.Error.WriteLine("usage: feature_codes SCAN CODES CLASSIFIED MODEL");
      return 2;
    }
    return Print.Guard(() => {
      using (var cloud = Cloud.Read(args[0]))
      using (var segmenter = new Segmenter("survey_codes") { Codes = File.ReadAllText(args[1]) })
      using (var coded = segmenter.Run(cloud))
      using (var classified = coded.GetCloud())
      using (var modeller = new Modeller("coded_objects"))
      using (var model = modeller.Run(cloud, coded)) {
        TellSegments(coded);
        classified.Write(args[2]);
        for (int i = 0; i < model.PartCount; ++i) {
          ModelPartResult part = model.Part(i);
          Console.WriteLine("{0}: {1}", part.PartClass, part.Name);
        }
        model.Write(args[3]);
      }
    });
  }

  /// <summary>Every object is a segment; its source label is its number in the list.</summary>
  static void TellSegments(Segmentation coded) {
    using (var segments = coded.GetSegments()) {
      double[] number = segments.Doubles("source_label"), points = segments.Doubles("inliers");
      for (int i = 0; i < points.Length; ++i)
        Console.WriteLine("object {0}: {1} points", (long)number[i], (long)points[i]);
    }
  }
}
