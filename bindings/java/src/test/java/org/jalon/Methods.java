// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;
import static org.jalon.Behaviours.same;
import static org.jalon.Behaviours.thrown;

import java.util.List;
import java.util.Map;
import java.util.function.Function;

/** The lists of methods of the workers; what objects say of themselves. */
final class Methods {
  private Methods() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("methods__are_those_that_can_be_created", Methods::created);
    all.put("texts__of_objects_say_what_they_are", Methods::described);
    all.put("methods__cannot_be_changed", Methods::unchanged);
    all.put("methods__by_codes_tell_their_objects", Methods::byCodes);
    all.put("methods__of_segmenters_and_comparers_work_on_a_cloud", Methods::run);
  }

  private static void created() {
    check(Segmenter.methods(), Segmenter::create, worker -> ((Segmenter) worker).params());
    check(Modeller.methods(), Modeller::create, worker -> ((Modeller) worker).params());
    check(Comparer.methods(), Comparer::create, worker -> ((Comparer) worker).params());
    check(Registrar.methods(), Registrar::create, worker -> ((Registrar) worker).params());
    check(Scanner.methods(), Scanner::create, worker -> ((Scanner) worker).params());
    expect(Segmenter.methods().contains("region_growing"), "region growing is a method");
  }

  /** Each name makes a worker, null makes the first one, the failure for another name lists them. */
  private static void check(List<String> names, Function<String, AutoCloseable> create, Function<Object, Params> params) {
    expect(names.size() >= 2, "names: " + names);
    for (String name : names) {
      expect(!told(create, params, name).isEmpty(), name);
    }
    same(told(create, params, null), told(create, params, names.get(0)));
    final String message = thrown(NotFoundException.class, () -> create.apply("no such method")).getMessage();
    expect(message.contains(String.join(", ", names)), message);
  }

  private static String told(Function<String, AutoCloseable> create, Function<Object, Params> params, String name) {
    try (AutoCloseable worker = create.apply(name); Params own = params.apply(worker)) {
      return own.toJson();
    } catch (Exception failure) {
      throw new AssertionError(name, failure);
    }
  }

  private static void described() {
    final Cloud cloud = Cloud.create(new double[] {0, 0, 0, 1, 0, 0});
    same("Cloud: 2 points", cloud.toString());
    cloud.setField("intensity", new short[2], "1");
    cloud.setStation("S1");
    same("Cloud: 2 points; fields: intensity; stations: 1", cloud.toString());
    try (Fields fields = cloud.fields(); Array points = cloud.points(); Task task = Task.create();
        Segmenter segmenter = Segmenter.create(); NormalsParams options = new NormalsParams();
        CloudCropBoxResult halves = cloud.cropBox(new double[] {-1, -1, -1, 0.5, 1, 1})) {
      same("Fields: intensity (1, 2 int16)", fields.toString());
      same("Array: 2 x 3 float64", points.toString());
      same("Task", task.toString());
      task.cancel();
      same("Task: cancelled", task.toString());
      expect(segmenter.toString().startsWith("Segmenter: {") && segmenter.toString().contains("distance_tolerance_m"), segmenter.toString());
      expect(options.toString().startsWith("NormalsParams: {"), options.toString());
      same("CloudCropBoxResult: inside = " + halves.inside() + ", outside = " + halves.outside(), halves.toString());
    }
    same("Gauge: 1 piece", new Gauge().addSphere(1).toString());
    same("Targets: 5", Survey.targets().toString());
    same("Rows: 2 x 3 float32", Rows.of(new float[6]).by(3).toString());
    cloud.close();
    same("Cloud (closed)", cloud.toString());
  }

  private static void byCodes() {
    final String codes = "7;0.1;0.1;-1;350\n8;0.3;0.1;1;350\n9;0;0;0;999999\n";
    try (Cloud cloud = Cloud.create(Behaviours.dome(60), 0); Segmenter segmenter = Segmenter.create("survey_codes").set("codes", codes);
        Segmentation coded = segmenter.run(cloud); Fields segments = coded.segments()) {
      expect(coded.notes().contains("\"name\":\"door 7\""), coded.notes());
      expect(coded.notes().contains("999999"), coded.notes());
      same(1, segments.doubles("label").length);
    }
  }

  private static void unchanged() {
    thrown(UnsupportedOperationException.class, () -> Segmenter.methods().add("mine"));
  }

  private static void run() {
    try (Cloud cloud = Cloud.create(Behaviours.dome(60), 0)) {
      for (String name : Segmenter.methods()) {
        if (name.equals("scan_lines")) {
          continue; // nobody scanned these points: they have no rows
        }
        try (Segmenter segmenter = Segmenter.create(name); Segmentation segmentation = segmenter.run(cloud);
            Fields points = segmentation.points()) {
          same(cloud.count(), (long) points.doubles("label").length);
        }
      }
      for (String name : Comparer.methods()) {
        try (Comparer comparer = Comparer.create(name); Comparison comparison = comparer.run(cloud, cloud);
            Fields points = comparison.points()) {
          expect(points.doubles("distance").length > 0, name);
        }
      }
    }
  }
}
