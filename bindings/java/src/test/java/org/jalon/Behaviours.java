// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.util.LinkedHashMap;
import java.util.Map;

/** Named behaviours with what they need; no test framework, so that they run everywhere. */
final class Behaviours {
  /** May throw anything; that is a failure. */
  interface Body {
    void run() throws Exception;
  }

  private Behaviours() {}

  static Map<String, Body> all() {
    final Map<String, Body> all = new LinkedHashMap<>();
    Arrays.addTo(all);
    Shapes.addTo(all);
    Errors.addTo(all);
    Tasks.addTo(all);
    Storms.addTo(all);
    Lifetimes.addTo(all);
    Methods.addTo(all);
    ObjectBytes.addTo(all);
    Setters.addTo(all);
    EveryCall.addTo(all);
    Misuse.addTo(all);
    return all;
  }

  static void expect(boolean holds, String what) {
    if (!holds) {
      throw new AssertionError(what);
    }
  }

  static void same(Object wanted, Object got) {
    expect(wanted.equals(got), "wanted " + wanted + ", got " + got);
  }

  /** The exception that the body throws, which must be of this class. */
  static <T extends Throwable> T thrown(Class<T> type, Body body) {
    try {
      body.run();
    } catch (Throwable failure) {
      expect(type.isInstance(failure), "wanted " + type.getSimpleName() + ", got " + failure);
      return type.cast(failure);
    }
    throw new AssertionError("wanted " + type.getSimpleName() + ", nothing was thrown");
  }

  /** side * side points of a gentle dome, 10 mm apart. */
  static float[] dome(int side) {
    final float[] xyz = new float[3 * side * side];
    for (int i = 0; i < side * side; ++i) {
      final float x = 0.01f * (i % side);
      final float y = 0.01f * (i / side);
      xyz[3 * i] = x;
      xyz[3 * i + 1] = y;
      xyz[3 * i + 2] = -0.02f * (x * x + y * y);
    }
    return xyz;
  }

  /** Prints one line a behaviour and the sum; for machines without JUnit. arguments: beginnings of names, none = all. */
  public static void main(String[] arguments) {
    int failed = 0;
    final Map<String, Body> all = all();
    if (arguments.length > 0) {
      all.keySet().removeIf(name -> java.util.Arrays.stream(arguments).noneMatch(name::startsWith));
    }
    for (Map.Entry<String, Body> behaviour : all.entrySet()) {
      try {
        behaviour.getValue().run();
        System.out.println("ok - " + behaviour.getKey());
      } catch (Throwable failure) {
        ++failed;
        System.out.println("not ok - " + behaviour.getKey());
        failure.printStackTrace(System.out);
      }
    }
    System.out.println((all.size() - failed) + " passed, " + failed + " failed, 0 skipped");
    System.exit(failed == 0 ? 0 : 1);
  }
}
