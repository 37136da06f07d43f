// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// Arrays in, progress and cancel, arrays out: normals of points that a program holds in memory.
// Build:  mcs -r:Jalon.dll 02_progress.cs Print.cs
using System;
using Jalon;

static class ProgressAndCancel {
  const int Side = 1000;

  static int Main() {
    return Print.Guard(Normals);
  }

  /// <summary>A gentle dome of a million points.</summary>
  static float[,] Dome() {
    var xyz = new float[Side * Side, 3];
    for (int i = 0; i < Side * Side; ++i) {
      float x = (float)(0.01f * (i % Side)) - 5, y = (float)(0.01f * (i / Side)) - 5;
      float square = (float)((float)(x * x) + (float)(y * y));
      xyz[i, 0] = x;
      xyz[i, 1] = y;
      xyz[i, 2] = -0.02f * square;
    }
    return xyz;
  }

  static void Normals() {
    using (var cloud = new Cloud(Dome())) {
      cloud.ComputeNormals(new NormalsOptions { K = 16 }, progress: (fraction, stage) => {
        Console.Error.Write("\r{0,3} % {1}", Print.Fixed(100 * fraction, 0), stage);
        return true;  // false cancels: OperationCanceledException
      });
      using (var fields = cloud.GetFields())
      using (var normals = fields["normal"]) {  // a view: no copy
        long top = Side * Side / 2 + Side / 2;
        Console.WriteLine("\nnormal at the top: {0} {1} {2}", Print.Fixed(normals[top, 0], 4),
                          Print.Fixed(normals[top, 1], 4), Print.Fixed(normals[top, 2], 4));
      }
    }
  }
}
