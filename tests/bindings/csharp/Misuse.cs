// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Jalon;

/// <summary>Drawn misuse of every public member: objects that are disposed of and texts that are none must throw, wild values may; nothing else comes of it.</summary>
static class Misuse {
  const int Seed = 24;
  static readonly string[] no_texts = {"zero \0 within", "\0", "half \ud83d", "\udc00"};
  static readonly double[] wild_numbers = {double.NaN, double.PositiveInfinity, double.NegativeInfinity, -1, 0, -1e300, 1e300};

  static readonly Random random = new Random(Seed);
  static readonly SortedDictionary<string, int> kinds = new SortedDictionary<string, int>();
  static readonly HashSet<MethodBase> seen = new HashSet<MethodBase>();
  static readonly List<string> wrong = new List<string>();
  static int thrown, taken;

  static int Misuses {
    get { return Check.Full ? 20000 : 1000; }
  }

  /// <summary>One object of each class, disposed of.</summary>
  static Dictionary<Type, Noun> Disposed() {
    var made = Wild.Samples();
    var targets = new Targets();
    targets.Add("a", new double[] {1, 2, 3});
    targets.Add("b", new double[] {4, 2, 3});
    targets.Add("c", new double[] {1, 7, 3});
    using (var registrar = new Registrar("targets")) made.Add(registrar.RunTargets(targets, targets));
    foreach (Type type in new[] {typeof(Network), typeof(Sections), typeof(Evaluation), typeof(ModelEvaluation), typeof(Trajectory)}) {
      made.Add((Noun)Objects.Of(type, type.Name, "self"));
    }
    made.Add(NoiseLaw.Fit(Survey.Scan, "deviation"));
    made.Add(new Params("normals"));
    foreach (Noun one in made) one.Dispose();
    return made.ToDictionary(one => one.GetType());
  }

  public static void Members__of_all_classes_throw_a_thousand_times() {
    var disposed = Disposed();
    MethodBase[] members = EveryCall.Nouns.SelectMany(EveryCall.WithSetters).Where(
        m => m.Name != "Dispose" && m.DeclaringType != typeof(object)).ToArray();
    byte[] before = Survey.Scan.ToBytes();
    while (thrown < Misuses) Draw(members[random.Next(members.Length)], disposed);
    Check.That(wrong.Count == 0, wrong.Count + ": " + string.Join("\n    ", wrong));
    Check.That(before.SequenceEqual(Survey.Scan.ToBytes()), "the cloud is another");
    Check.That(seen.Count > 250, seen.Count + " members");
    Console.WriteLine("FIGURE misuses of C#: {0} of {1} members threw ({2}), {3} wild values were taken", thrown, seen.Count,
                      string.Join(", ", kinds.Select(k => k.Value + " " + k.Key)), taken);
  }

  static void Draw(MethodBase member, Dictionary<Type, Noun> disposed) {
    Type type = member.DeclaringType;
    bool isStatic = member.IsStatic || member.IsConstructor;
    if (!isStatic && disposed.ContainsKey(type) && random.Next(member.IsSpecialName ? 12 : 4) == 0) {
      if (member.Name == "ToString" || type == typeof(ArrayView) && member.IsSpecialName && member.Name != "get_Data") return;
      object real = Objects.Subject(type, member.Name);
      Call(member, disposed[type], EveryCall.Arguments(member, real, true), "disposed self", true);
      return;
    }
    ParameterInfo[] parameters = member.GetParameters();
    if (parameters.Length == 0) return;
    object self = isStatic ? null : Objects.Subject(type, member.Name);
    object[] arguments = EveryCall.Arguments(member, self, true);
    int i = random.Next(parameters.Length);
    Type parameter = parameters[i].ParameterType;
    if (disposed.ContainsKey(parameter) && random.Next(4) != 0) {
      arguments[i] = disposed[parameter];
      Call(member, self, arguments, "disposed argument", true);
    } else if (parameter == typeof(string) && random.Next(4) != 0) {
      arguments[i] = no_texts[random.Next(no_texts.Length)];
      Call(member, self, arguments, "no text", true);
    } else if (parameter != typeof(bool) && !parameter.IsByRef && random.Next(3) == 0) {
      arguments[i] = WildValue(parameter);
      Call(member, self, arguments, "wild " + parameter.Name, false);
    }
  }

  /// <summary>Null, or a number or an array that hardly fits.</summary>
  static object WildValue(Type type) {
    double number = wild_numbers[random.Next(wild_numbers.Length)];
    if (type == typeof(double)) return number;
    if (type == typeof(long)) return new[] {0, -1, long.MaxValue, long.MinValue}[random.Next(4)];
    if (type == typeof(int)) return new[] {0, -1, int.MaxValue, int.MinValue}[random.Next(4)];
    if (type == typeof(string)) return random.Next(2) == 0 ? null : "nowhere/wild \"\n%s";
    if (type == typeof(bool[])) return new bool[random.Next(4)];
    if (type == typeof(IEnumerable<Cloud>)) return new[] {Survey.Scan, null};
    if (type == typeof(double[])) return random.Next(4) == 0 ? null : new double[] {number, 1, number};
    if (type == typeof(ArrayArgument)) {
      return new ArrayArgument[] {default(ArrayArgument), new double[random.Next(8)], new double[] {number, 1, number, 2, 3}, new long[] {-5, 1},
                                  new short[0]}[random.Next(5)];
    }
    return type.IsValueType ? Activator.CreateInstance(type) : null;
  }

  static void Call(MethodBase member, object self, object[] arguments, string what, bool must) {
    string name = member.DeclaringType.Name + "." + member + ", " + what;
    var method = member as MethodInfo;
    if (method != null && method.IsGenericMethodDefinition) method = method.MakeGenericMethod(typeof(double));
    try {
      var result = (method != null ? method.Invoke(self, arguments) : ((ConstructorInfo)member).Invoke(arguments)) as Noun;
      if (result != null && result != self) result.Dispose();
      if (must) wrong.Add(name + " was taken");
      ++taken;
    } catch (TargetInvocationException error) {
      Exception cause = error.InnerException;
      var own = cause as JalonException;
      if (!Wild.Allowed(cause) || own != null && own.Status == Status.ErrorInternal) wrong.Add(name + ": " + cause);
      ++thrown;
      kinds[what] = (kinds.ContainsKey(what) ? kinds[what] : 0) + 1;
      seen.Add(member);
    }
  }
}
