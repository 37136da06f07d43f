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
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;

/** Drawn misuse of every public member: closed objects and texts that are none must throw, wild values may; nothing else comes of it. */
final class Misuse {
  private static final int MISUSES = "1".equals(System.getenv("JALON_FULL")) ? 20000 : 1000;
  private static final long SEED = 24;
  private static final Set<String> OF_CLOSED_OBJECTS = Set.of("close", "isClosed", "toString", "equals", "hashCode");
  private static final String[] NO_TEXTS = {"zero \0 within", "\0", "half \ud83d", "\udc00"};
  private static final double[] WILD = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, -1, 0, -1e300, 1e300};

  private final Random random = new Random(SEED);
  private final Map<Class<?>, NativeObject> closed = new HashMap<>();
  private final Map<String, Integer> kinds = new TreeMap<>();
  private final Set<Executable> seen = new HashSet<>();
  private final List<String> wrong = new ArrayList<>();
  private int thrown;
  private int taken;

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("misuse__of_drawn_members_throws", () -> new Misuse().run());
  }

  /** One object of each class, closed. */
  private void close() throws ReflectiveOperationException {
    for (Class<?> type : EveryCall.NOUNS) {
      if (NativeObject.class.isAssignableFrom(type) && type != Jalon.class) {
        final NativeObject own = (NativeObject) EveryCall.subject(type, type.getMethod("close"));
        own.close();
        closed.put(type, own);
      }
    }
  }

  private void run() throws Exception {
    final List<Executable> members = new ArrayList<>();
    for (Class<?> type : EveryCall.NOUNS) {
      members.addAll(EveryCall.withSetters(type));
    }
    close();
    final byte[] before = Survey.get().scan.toBytes();
    while (thrown < MISUSES) {
      misuse(members.get(random.nextInt(members.size())));
    }
    expect(wrong.isEmpty(), wrong.size() + ": " + String.join("\n    ", wrong));
    expect(Arrays.equals(before, Survey.get().scan.toBytes()), "the cloud is another");
    expect(seen.size() > 400, seen.size() + " members");
    System.out.println("FIGURE misuses of Java: " + thrown + " of " + seen.size() + " members threw (" + kinds + "), " + taken
        + " wild values were taken");
  }

  private void misuse(Executable member) throws Exception {
    final Class<?> type = member.getDeclaringClass();
    final boolean isStatic = Modifier.isStatic(member.getModifiers()) || member instanceof Constructor;
    if (!isStatic && closed.containsKey(type) && random.nextInt(4) == 0) {
      if (!OF_CLOSED_OBJECTS.contains(member.getName())) {
        final Object self = EveryCall.subject(type, member);
        call(member, closed.get(type), arguments(member, self), "closed self", true);
      }
    } else if (member.getParameterCount() > 0 && !(member.getName().equals("close"))) {
      final Object self = isStatic ? null : EveryCall.subject(type, member);
      final Object[] arguments = arguments(member, self);
      final int i = random.nextInt(arguments.length);
      final Class<?> parameter = member.getParameterTypes()[i];
      if (closed.containsKey(parameter) && random.nextInt(4) != 0) {
        arguments[i] = closed.get(parameter);
        call(member, self, arguments, "closed argument", true);
      } else if (parameter == String.class && random.nextInt(4) != 0) {
        arguments[i] = NO_TEXTS[random.nextInt(NO_TEXTS.length)];
        call(member, self, arguments, "no text", true);
      } else if (parameter != boolean.class && random.nextInt(3) == 0) {
        arguments[i] = wild(parameter, arguments[i]);
        call(member, self, arguments, "wild " + parameter.getSimpleName(), false);
      }
    }
  }

  private static Object[] arguments(Executable member, Object self) {
    final Object[] arguments = new Object[member.getParameterCount()];
    for (int i = 0; i < arguments.length; ++i) {
      arguments[i] = RealValues.of(member, member.getParameters()[i], self);
    }
    return arguments;
  }

  /** Null, or a number or an array that hardly fits. */
  private Object wild(Class<?> type, Object real) {
    final double number = WILD[random.nextInt(WILD.length)];
    if (type == double.class) {
      return number;
    } else if (type == long.class) {
      return (long) number;
    } else if (type == int.class) {
      return (int) number;
    } else if (type == String.class) {
      return random.nextBoolean() ? null : "nowhere/wild \"\n%s";
    } else if (type == double[][].class) {
      return new double[][] {{1, 2, 3}, random.nextBoolean() ? null : new double[] {1}};
    } else if (type == List.class) {
      return Arrays.asList(Survey.get().scan, null);
    } else if (type == boolean[].class) {
      return new boolean[random.nextInt(4)];
    } else if (type.isArray() && random.nextInt(4) != 0) {
      return RealValues.array(type, "x", random.nextBoolean() ? new double[random.nextInt(8)] : new double[] {number, 1, number, 2, 3});
    }
    return null;
  }

  private void call(Executable member, Object self, Object[] arguments, String what, boolean must) throws Exception {
    final String name = member.toGenericString().replaceAll("(org\\.jalon|java\\.\\w+)\\.", "") + ", " + what + " " + Arrays.deepToString(arguments);
    try {
      final Object result = member instanceof Constructor ? ((Constructor<?>) member).newInstance(arguments) : ((Method) member).invoke(self, arguments);
      if (result instanceof NativeObject && result != self) {
        ((NativeObject) result).close();
      }
      if (must) {
        wrong.add(name + " was taken");
      }
      ++taken;
    } catch (InvocationTargetException failure) {
      final Throwable cause = failure.getCause();
      final boolean isKnown = cause instanceof JalonException || cause instanceof IndexOutOfBoundsException;
      if (!isKnown || cause.getMessage() == null || cause instanceof JalonException && ((JalonException) cause).status() == Jalon.ERROR_INTERNAL) {
        wrong.add(name + ": " + cause);
      }
      ++thrown;
      kinds.merge(what, 1, Integer::sum);
      seen.add(member);
    }
  }
}
