// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;
import static org.jalon.Behaviours.same;
import static org.jalon.Behaviours.thrown;

import java.util.List;
import java.util.Map;
import java.util.function.Function;

/** The lists of methods of the workers. */
final class Methods {
  private Methods() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("methods__are_those_that_can_be_created", Methods::created);
    all.put("methods__cannot_be_changed", Methods::unchanged);
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

  private static void unchanged() {
    thrown(UnsupportedOperationException.class, () -> Segmenter.methods().add("mine"));
  }

  private static void run() {
    try (Cloud cloud = Cloud.create(Behaviours.dome(60), 0)) {
      for (String name : Segmenter.methods()) {
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
