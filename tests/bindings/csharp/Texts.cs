// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.IO;
using Jalon;

static class Texts {
  const string Odd = "façade_漢_😀";

  public static void Files__of_any_name_are_written_and_read() {
    string folder = Path.Combine(Path.GetTempPath(), "jalon_" + Guid.NewGuid().ToString("N"));
    Directory.CreateDirectory(folder);
    string path = Path.Combine(folder, Odd + ".las");
    try {
      using (var cloud = new Cloud(Scenes.Plane(10))) cloud.Write(path);
      Check.That(File.Exists(path), "the file has another name");
      using (Cloud again = Cloud.Read(path)) Check.Equal(100L, again.Count, "points");
      string message = Check.Throws<NotFoundException>(() => Cloud.Read(path + "x")).Message;
      Check.That(message.Contains(Odd), "the message names another file: " + message);
    } finally {
      Directory.Delete(folder, true);
    }
  }

  public static void Texts__cross_as_utf8() {
    using (var cloud = new Cloud(new double[3]) { Crs = Odd }) {
      Check.Equal(Odd, cloud.Crs, "crs");
      cloud.SetField(Odd, new double[1], "m²", "ø 漢");
      using (Fields fields = cloud.GetFields()) {
        Check.Equal(Odd, fields.Names[0], "field");
        Check.Equal("m² ø 漢", fields.Info(0).Unit + " " + fields.Info(0).Meaning, "unit and meaning");
      }
      cloud.SetStation(Odd);
      Check.Equal(Odd, cloud.Station(0).Name, "station");
    }
  }

  public static void Texts__that_are_none_are_refused() {
    using (var cloud = new Cloud(new double[3])) {
      Check.Throws<InvalidArgumentException>(() => cloud.Crs = "half \ud83d");
      Check.Throws<InvalidArgumentException>(() => cloud.Crs = "zero \0 within");
    }
  }

  public static void Objects__say_what_they_are() {
    var cloud = new Cloud(new double[] {0, 0, 0, 1, 0, 0});
    Check.Equal("Cloud: 2 points", cloud.ToString(), "cloud");
    cloud.SetField("intensity", new short[2], "1");
    cloud.SetStation("S1");
    Check.Equal("Cloud: 2 points; fields: intensity; stations: 1", cloud.ToString(), "with a field");
    using (Fields fields = cloud.GetFields()) Check.Equal("Fields: intensity (1, 2 Int16)", fields.ToString(), "fields");
    using (ArrayView points = cloud.GetPoints()) Check.Equal("ArrayView: 2 x 3 Float64", points.ToString(), "view");
    using (var task = new JalonTask()) {
      Check.Equal("JalonTask", task.ToString(), "task");
      task.Cancel();
      Check.Equal("JalonTask: cancelled", task.ToString(), "cancelled");
    }
    using (var options = new NormalsOptions()) Check.That(options.ToString().StartsWith("NormalsOptions: {"), options.ToString());
    using (var segmenter = new Segmenter()) Check.That(segmenter.ToString().StartsWith("Segmenter: {"), segmenter.ToString());
    using (CloudCropBoxResult halves = cloud.CropBox(new double[] {-1, -1, -1, 0.5, 1, 1})) {
      Check.Equal("CloudCropBoxResult: Inside = " + halves.Inside + ", Outside = " + halves.Outside, halves.ToString(), "result");
    }
    using (var gauge = new Gauge()) {
      gauge.AddBox(new double[] {1, 1, 2});
      Check.Equal("Gauge: 1 piece", gauge.ToString(), "gauge");
    }
    CloudOctreeCubeResult cube = cloud.OctreeCube();
    Check.That(cube.ToString().StartsWith("CloudOctreeCubeResult: Origin = [") && !cube.ToString().Contains(",5"), cube.ToString());
    cloud.Dispose();
    Check.Equal("Cloud (disposed of)", cloud.ToString(), "disposed of");
  }

  public static void Version__is_a_text() {
    Check.That(Library.Version().Split('.').Length == 3, Library.Version());
    Check.Equal("invalid argument", Library.StatusName((int)Status.ErrorInvalidArgument), "status");
  }
}
