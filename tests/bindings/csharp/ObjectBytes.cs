// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Linq;
using Jalon;

static class ObjectBytes {
  static Cloud Made() {
    var cloud = new Cloud(Scenes.Plane(40)) { Crs = "EPSG:2154" };
    cloud.SetField("count", new long[1600], "points", "how many");
    return cloud;
  }

  public static void Bytes__bring_back_a_cloud() {
    using (Cloud cloud = Made()) {
      byte[] bytes = cloud.ToBytes();
      using (Cloud back = Cloud.FromBytes(bytes))
      using (Fields fields = back.GetFields()) {
        Check.Equal("EPSG:2154", back.Crs, "crs");
        Check.Equal("points", fields.Info(0).Unit, "unit");
        Check.That(bytes.SequenceEqual(back.ToBytes()), "other bytes");
      }
    }
  }

  public static void Bytes__bring_back_parameters_workers_and_results() {
    using (Cloud cloud = Made())
    using (var segmenter = new Segmenter("region_growing") { MinPoints = 20 })
    using (Segmenter back = Segmenter.FromBytes(segmenter.ToBytes()))
    using (Segmentation made = back.Run(cloud))
    using (Segmentation again = Segmentation.FromBytes(made.ToBytes())) {
      Check.Equal(20L, back.MinPoints, "parameter");
      Check.That(made.ToBytes().SequenceEqual(again.ToBytes()), "other bytes");
    }
    using (var options = new Params("normals"))
    using (Params back = Params.FromBytes(options.ToBytes())) {
      Check.Equal(options.ToJson(), back.ToJson(), "values");
    }
  }

  public static void Bytes__that_are_damaged_are_refused() {
    using (Cloud cloud = Made()) {
      byte[] bytes = cloud.ToBytes();
      Check.Throws<InvalidArgumentException>(() => Model.FromBytes(bytes));
      Check.Throws<InvalidArgumentException>(() => Cloud.FromBytes((byte[])null));
      Check.Throws<InvalidArgumentException>(() => Cloud.FromBytes(new double[3]));
      Check.Throws<FileFormatException>(() => Cloud.FromBytes(new byte[0]));
      bytes[100] ^= 1;
      string message = Check.Throws<FileFormatException>(() => Cloud.FromBytes(bytes)).Message;
      Check.That(message.Contains("checksum"), message);
    }
  }

  public static void Copies__are_objects_of_their_own() {
    using (Cloud cloud = Made())
    using (Cloud copy = cloud.Copy()) {
      copy.Crs = "";
      Check.Equal("EPSG:2154", cloud.Crs, "crs");
    }
    using (var scanner = new Scanner("sample") { Seed = 9 })
    using (Scanner copy = scanner.Copy()) {
      copy.Seed = 10;
      Check.Equal(9L, scanner.Seed, "seed");
    }
  }
}
