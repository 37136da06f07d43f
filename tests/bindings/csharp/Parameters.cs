// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Linq;
using System.Reflection;
using Jalon;

static class Parameters {
  public static void Properties__set_and_tell_the_parameters_of_a_worker() {
    using (var segmenter = new Segmenter { DistanceToleranceM = 0.01 }) {
      Check.Equal(0.01, segmenter.DistanceToleranceM, "double");
      Check.Equal(0.01, (double)segmenter.Parameters.Get("distance_tolerance_m"), "by its name");
      segmenter.Parameters.Set("distance_tolerance_m", 1);
      Check.Equal(1.0, segmenter.DistanceToleranceM, "a whole number where a double is wanted");
      segmenter.ChecksItsValues();
    }
  }

  static void ChecksItsValues(this Segmenter segmenter) {
    segmenter.ToleranceFrom = "sigma";
    Check.Equal("sigma", segmenter.ToleranceFrom, "choice");
    Check.Throws<InvalidArgumentException>(() => segmenter.ToleranceFrom = "nothing");
    Check.Throws<InvalidArgumentException>(() => segmenter.DistanceToleranceM = -1);
  }

  public static void Methods__are_those_that_can_be_made_the_default_first() {
    IsListed(Segmenter.Methods(), name => new Segmenter(name));
    IsListed(Modeller.Methods(), name => new Modeller(name));
    IsListed(Comparer.Methods(), name => new Comparer(name));
    IsListed(Registrar.Methods(), name => new Registrar(name));
    IsListed(Scanner.Methods(), name => new Scanner(name));
    Check.That(Segmenter.Methods().Contains("region_growing"), "region growing is a method");
  }

  static void IsListed(string[] names, Func<string, Worker> made) {
    Check.That(names.Length >= 2, names.Length + " names");
    foreach (string name in names) made(name).Dispose();
    using (Worker byDefault = made(null), first = made(names[0]))
      Check.Equal(byDefault.Parameters.ToJson(), first.Parameters.ToJson(), "the default's parameters");
    string message = Check.Throws<NotFoundException>(() => made("no such method")).Message;
    Check.That(message.Contains(string.Join(", ", names)), message);
  }

  public static void Every_listed_method__works_on_a_cloud() {
    using (var cloud = new Cloud(Scenes.Plane(60))) {
      foreach (string name in Segmenter.Methods().Where(name => !name.EndsWith("_codes") && name != "scan_lines")) {
        using (var segmenter = new Segmenter(name))
        using (Segmentation segmentation = segmenter.Run(cloud))
        using (Fields segments = segmentation.GetSegments())
          Check.That(segments.View("area").Count >= 1, name + " finds the plane");
      }
      foreach (string name in Comparer.Methods()) {
        using (var comparer = new Comparer(name))
        using (Comparison comparison = comparer.Run(cloud, cloud))
        using (Fields points = comparison.GetPoints()) Check.That(points.View("distance").Count > 0, name);
      }
    }
  }

  public static void Methods_by_codes__tell_their_objects() {
    const string Codes = "7;2600001;1200001;399;350\n8;2600003;1200001;401;350\n9;0;0;0;999999\n";
    using (var cloud = new Cloud(Scenes.Plane(60)))
    using (var segmenter = new Segmenter("survey_codes") { Codes = Codes })
    using (Segmentation coded = segmenter.Run(cloud))
    using (Fields segments = coded.GetSegments()) {
      Check.That(coded.Notes.Contains("\"name\":\"door 7\""), coded.Notes);
      Check.That(coded.Notes.Contains("999999"), coded.Notes);
      Check.Equal(1L, (long)segments.View("label").Count, "objects with points");
    }
  }

  public static void Parameter_of_another_method__is_not_found() {
    using (var growing = new Segmenter("region_growing")) {
      Check.Throws<NotFoundException>(() => growing.ToleranceFrom = "hand");
      Check.Throws<NotFoundException>(() => growing.Parameters.Set("no_such_parameter", 1.0));
      Check.Throws<NotFoundException>(() => growing.Parameters.Get("no_such_parameter"));
    }
  }

  public static void Every_property_of_every_option__can_be_read_and_set_back() {
    int properties = 0;
    foreach (Type type in typeof(Params).Assembly.GetTypes().Where(t => t.BaseType == typeof(Params))) {
      using (var options = (Params)Activator.CreateInstance(type)) {
        var own = type.GetProperties(BindingFlags.Public | BindingFlags.Instance | BindingFlags.DeclaredOnly);
        Check.Equal(options.Count, (long)own.Length, type.Name + " has a property a row");
        string before = options.ToJson();
        foreach (PropertyInfo property in own) property.SetValue(options, property.GetValue(options, null), null);
        Check.Equal(before, options.ToJson(), type.Name);
        properties += own.Length;
      }
    }
    Check.That(properties > 200, properties + " properties");
  }

  public static void Parameters__go_to_json_and_back() {
    using (var options = new NormalsOptions { K = 21, Viewpoint = new double[] {1, 2, 3}, Curvature = true })
    using (var again = new NormalsOptions()) {
      again.FromJson(options.ToJson());
      Check.Equal(21L, again.K, "whole number");
      Check.Equal("1 2 3", string.Join(" ", again.Viewpoint), "doubles");
      Check.That(again.Curvature, "flag");
    }
  }
}
