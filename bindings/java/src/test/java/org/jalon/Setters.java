// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;
import static org.jalon.Behaviours.same;

import java.lang.reflect.Method;
import java.util.Map;
import java.util.TreeMap;

/** The typed setters: each parameter of each operation and of each method of each worker has one, and it sets that one. */
final class Setters {
  private Setters() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("setters__of_operations_set_each_parameter", Setters::operations);
    all.put("setters__of_workers_set_each_parameter", Setters::workers);
  }

  /** Whether it is one of these, and not of another kind. */
  static boolean isSetter(Method method) {
    return method.getName().startsWith("set") && method.getReturnType() == method.getDeclaringClass()
        && method.getDeclaringClass() != Params.class;
  }

  private static void operations() throws Exception {
    int count = 0;
    for (long i = 0; i < Params.operationCount(); ++i) {
      final String operation = Params.operationName(i);
      try (Params params = (Params) Class.forName("org.jalon." + title(operation) + "Params").getConstructor().newInstance()) {
        count += setBack(params, params);
      }
    }
    expect(count > 200, "only " + count + " parameters");
  }

  private static void workers() throws Exception {
    int count = 0;
    for (Class<?> type : new Class<?>[] {Segmenter.class, Modeller.class, Comparer.class, Registrar.class, Scanner.class}) {
      for (Object name : (java.util.List<?>) type.getMethod("methods").invoke(null)) {
        try (NativeObject worker = (NativeObject) type.getMethod("create", String.class).invoke(null, name);
            Params params = (Params) type.getMethod("params").invoke(worker)) {
          count += setBack(worker, params);
          setByName(worker, params);
        }
      }
    }
    expect(count > 100, "only " + count + " parameters");
  }

  /** Each parameter set by its setter to another value, where there is a switch, and to what it is; how many. */
  private static int setBack(Object owner, Params params) throws Exception {
    final Map<String, Method> setters = new TreeMap<>();
    for (Method method : owner.getClass().getDeclaredMethods()) {
      if (isSetter(method) && method.getParameterCount() == 1) {
        setters.put(method.getName(), method);
      }
    }
    final String before = params.toJson();
    for (long i = 0; i < params.count(); ++i) {
      final ParamsInfoResult row = params.info(i);
      final Method setter = setters.get("set" + title(row.name()));
      expect(setter != null, owner.getClass().getSimpleName() + " has no setter of " + row.name());
      final Object value = valueOf(params, row);
      if (value instanceof Boolean) {
        setter.invoke(owner, !(boolean) value);
        same(!(boolean) value, params.getBool(row.name()));
      }
      same(owner, setter.invoke(owner, value));
    }
    same(before, params.toJson());
    same(params.names().size(), (int) params.count());
    return (int) params.count();
  }

  private static Object valueOf(Params params, ParamsInfoResult row) {
    switch (row.type()) {
      case 1: return params.getDouble(row.name());
      case 2: return params.getInt64(row.name());
      case 3: return params.getBool(row.name());
      case 6: return params.getDoubles(row.name());
      default: return params.getString(row.name());
    }
  }

  /** set(name, value) of the worker, once for each type that it has. */
  private static void setByName(Object worker, Params params) throws Exception {
    final String before = params.toJson();
    for (long i = 0; i < params.count(); ++i) {
      final Object value = valueOf(params, params.info(i));
      final Class<?> type = value instanceof Double ? double.class : value instanceof Long ? long.class
          : value instanceof Boolean ? boolean.class : value.getClass();
      same(worker, worker.getClass().getMethod("set", String.class, type).invoke(worker, params.info(i).name(), value));
      if (value instanceof Double && (double) value == Math.rint((double) value) && Math.abs((double) value) < 1e15) {
        final Object whole = ((Double) value).longValue();
        worker.getClass().getMethod("set", String.class, long.class).invoke(worker, params.info(i).name(), whole);
      }
    }
    same(before, params.toJson());
  }

  private static String title(String name) {
    final StringBuilder title = new StringBuilder();
    for (String part : name.split("_")) {
      title.append(part.substring(0, 1).toUpperCase(java.util.Locale.ROOT)).append(part.substring(1));
    }
    return title.toString();
  }
}
