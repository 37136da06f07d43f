// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;

import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Every public method of every public class, in each of its overloads, with real data: none fails. */
final class EveryCall {
  static final Class<?>[] NOUNS = {Adjustment.class, Cloud.class, CloudBuilder.class, Comparer.class, Comparison.class, Evaluation.class,
      Fields.class, Gauge.class, Jalon.class, Model.class, ModelEvaluation.class, Modeller.class, Network.class, NoiseLaw.class, Params.class,
      Registrar.class, Registration.class, Rows.class, Scanner.class, Sections.class, Segmentation.class, Segmenter.class, Targets.class,
      Task.class, Trajectory.class, Array.class};
  private static final Map<Class<?>, Object> GIVEN = new HashMap<>();

  private EveryCall() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    for (Class<?> type : NOUNS) {
      all.put("every_call__of_" + type.getSimpleName(), () -> calls(type));
    }
    all.put("every_call__of_results", EveryCall::results);
  }

  /** The overloads of a class by name and types, so that each run makes the same calls. */
  private static List<Executable> members(Class<?> type) {
    final List<Executable> members = withSetters(type);
    members.removeIf(member -> member instanceof Method && Setters.isSetter((Method) member));
    return members;
  }

  static List<Executable> withSetters(Class<?> type) {
    final List<Executable> members = new ArrayList<>();
    for (Method method : type.getDeclaredMethods()) {
      if (Modifier.isPublic(method.getModifiers()) && !method.isSynthetic()) {
        members.add(method);
      }
    }
    members.addAll(List.of(type.getConstructors()));
    members.sort(Comparator.comparing(Executable::toGenericString));
    return members;
  }

  private static void calls(Class<?> type) throws Exception {
    final Map<String, String> failures = new LinkedHashMap<>();
    int count = 0;
    for (Executable member : members(type)) {
      final String failure = call(type, member);
      if (failure != null) {
        failures.put(member.toGenericString().replaceAll("(org\\.jalon|java\\.\\w+)\\.", ""), failure);
      }
      ++count;
    }
    expect(failures.isEmpty(), failures.size() + " of " + count + " calls: " + failures.toString().replace(", public", "\n    public"));
    expect(count > 2, "only " + count + " calls");
  }

  /** What failed, or null. */
  private static String call(Class<?> type, Executable member) throws Exception {
    final Object self = Modifier.isStatic(member.getModifiers()) || member instanceof Constructor ? null : subject(type, member);
    final Object[] arguments = new Object[member.getParameterCount()];
    for (int i = 0; i < arguments.length; ++i) {
      arguments[i] = RealValues.of(member, member.getParameters()[i], self);
    }
    try {
      final Object result = member instanceof Constructor ? ((Constructor<?>) member).newInstance(arguments)
          : ((Method) member).invoke(self, arguments);
      if (result != null) {
        expect(!result.toString().contains("org.jalon."), result + " says nothing");
        GIVEN.putIfAbsent(result.getClass(), result);
      }
      return null;
    } catch (InvocationTargetException failure) {
      return failure.getCause().toString();
    }
  }

  /** The results that the calls gave: their parts, their text, their close. */
  private static void results() throws Exception {
    int count = 0;
    for (Map.Entry<Class<?>, Object> result : new ArrayList<>(GIVEN.entrySet())) {
      if (!result.getKey().getSimpleName().endsWith("Result")) {
        continue;
      }
      final List<Executable> members = members(result.getKey());
      members.sort(Comparator.comparing(member -> member.getName().equals("close"))); // at last
      for (Executable member : members) {
        ((Method) member).invoke(result.getValue());
      }
      ++count;
    }
    expect(count > 15, "only " + count + " classes of results");
  }

  /** What a method is called of; what it changes or closes is its own. */
  static Object subject(Class<?> type, Executable member) {
    final Survey survey = Survey.get();
    final String name = member.getName();
    if (type == Cloud.class) {
      final boolean flat = name.startsWith("fitSphere") || name.startsWith("fitCircle") || name.equals("measureTargets");
      final Cloud cloud = Survey.copy(flat ? survey.ball : name.equals("fitCylinder") ? survey.pipe : survey.scan);
      if (name.equals("invertNormals")) {
        cloud.computeNormals();
      }
      return cloud;
    } else if (type == CloudBuilder.class) {
      return builder(name, member);
    } else if (type == Model.class && name.equals("removeCopy")) {
      return survey.repeated;
    } else if (type == Model.class && name.equals("perturbStrips")) {
      return survey.scene.buildingStrips().model();
    } else if (type == Trajectory.class && name.equals("adjust")) {
      return survey.driven.trajectory();
    } else if (type == Adjustment.class && name.equals("close")) {
      return Survey.adjusted(survey.driven);
    } else if (type == Scanner.class && name.equals("drive")) {
      return Scanner.create("mobile").set("pulses", 50);
    } else if (type == Array.class) {
      return array(name);
    } else if (type == Segmentation.class && (name.equals("close") || name.equals("pick"))) {
      return Segmentation.start(survey.scan);
    } else if (name.equals("close") && type == Comparison.class) {
      return survey.comparison.thirdEpoch(survey.comparison, 0.01);
    } else if (name.equals("close") && type == Registration.class) {
      return Registrar.create("targets").runTargets(Survey.targets(), Survey.targets());
    } else if (name.equals("close") && type == NoiseLaw.class) {
      return NoiseLaw.fit(survey.scan, "deviation");
    } else if (type == Comparer.class) {
      final boolean cores = List.of("readM3c2File", "runCore", "useRegistration").contains(name);
      return Comparer.create(cores ? "m3c2" : "distance");
    } else if (type == Registrar.class) {
      return Registrar.create(name.equals("runTargets") ? "targets" : "icp");
    }
    return object(type, type.getSimpleName() + "." + name, "self");
  }

  /** Those of a real object of the class whose method takes them. */
  static byte[] bytes(Executable member) {
    final Class<?> type = member.getDeclaringClass();
    try {
      return (byte[]) type.getMethod("toBytes").invoke(subject(type, member));
    } catch (ReflectiveOperationException failure) {
      throw new IllegalStateException(failure);
    }
  }

  /** A column of the type that the method shows. */
  private static Array array(String name) {
    final Rows data = name.equals("floats") ? Rows.of(new float[3]) : name.equals("longs") ? Rows.of(new long[3])
        : name.equals("ints") ? Rows.of(new int[3]) : name.equals("shorts") ? Rows.of(new short[3]) : Rows.of(new double[3]);
    try (Cloud cloud = Cloud.create(new double[9])) {
      cloud.setField("mine", data);
      return cloud.fields().view("mine");
    }
  }

  private static CloudBuilder builder(String name, Executable member) {
    final CloudBuilder builder = CloudBuilder.create();
    if (name.equals("appendField") || name.equals("seal")) {
      final Class<?> data = name.equals("seal") ? double[].class : member.getParameters()[1].getType();
      builder.declareField("mine", type(data.getSimpleName().toLowerCase(java.util.Locale.ROOT)));
      builder.appendPoints(new double[12]);
    }
    if (name.equals("seal")) {
      builder.appendField("mine", new double[4]);
    }
    return builder;
  }

  private static int type(String array) {
    return array.startsWith("float") ? Jalon.FLOAT32 : array.startsWith("long") ? Jalon.INT64 : array.startsWith("int") ? Jalon.INT32
        : array.startsWith("short") ? Jalon.INT16 : array.startsWith("byte") || array.startsWith("bool") ? Jalon.UINT8 : Jalon.FLOAT64;
  }

  /** A real object of this class. */
  static Object object(Class<?> type, String where, String name) {
    final Survey survey = Survey.get();
    final String of = where.substring(where.indexOf('.') + 1);
    final boolean isDriven = where.equals("Trajectory.adjust") || where.equals("Adjustment.apply");
    if (isDriven && type == Cloud.class) {
      return survey.driven.cloud();
    } else if (isDriven && type == Model.class) {
      return survey.driven.model();
    } else if (type == Cloud.class) {
      return name.equals("compared") || name.equals("moving") || name.equals("b") ? survey.second : survey.scan;
    } else if (type == Model.class) {
      final boolean simple = of.equals("gaugeSweepModel") && name.equals("gauge");
      return simple ? Survey.tetrahedron() : of.equals("close") ? Jalon.sceneCreate() : of.equals("scene") ? survey.scene : survey.model;
    } else if (type == Params.class) {
      return name.equals("self") ? new NormalsParams() : null;
    } else if (type == Comparison.class) {
      return name.equals("reverse") ? survey.reverse : survey.comparison;
    } else if (type == Fields.class) {
      return name.equals("places") ? survey.swept.places() : name.equals("intervals") ? survey.swept.intervals()
          : name.equals("changes") ? survey.changes : name.equals("forward_points") ? survey.forwardPoints
          : name.equals("reverse_points") ? survey.reversePoints : survey.scan.fields();
    } else if (type == java.util.List.class) {
      return Survey.clouds();
    }
    return type == Task.class ? Task.create() : type == Segmentation.class ? Survey.get().segmentation
        : type == Registration.class ? survey.registration : type == NoiseLaw.class ? survey.law
        : type == Trajectory.class ? Survey.drive() : type == Adjustment.class ? survey.adjustment
        : type == Network.class ? Survey.network() : type == Sections.class ? survey.scan.sections()
        : type == Gauge.class ? Survey.gauge() : type == Targets.class ? Survey.targets() : type == Array.class ? survey.scan.points()
        : type == Rows.class ? Rows.of(new double[12]) : type == Evaluation.class ? survey.segmentation.evaluate(survey.segmentation)
        : type == ModelEvaluation.class ? survey.model.evaluate(survey.scene) : type == Segmenter.class ? Segmenter.create()
        : type == Modeller.class ? Modeller.create() : type == Scanner.class ? Scanner.create()
        : type == ProgressListener.class ? (ProgressListener) (fraction, stage) -> true
        : type == LogListener.class ? (LogListener) (level, text) -> { } : null;
  }

  static String text(String where, String name, Map<String, String> texts) {
    final String text = texts.getOrDefault(where + "." + name, texts.get(name));
    final boolean isFile = name.equals("path") || name.equals("source") || name.equals("target");
    return isFile ? Survey.get().path(text == null ? where.substring(where.indexOf('.') + 1) + texts.get("svg") : text) : text;
  }
}
