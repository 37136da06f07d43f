// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Jalon;

/// <summary>Every public member of every public class, with all of its arguments and with its defaults, on real data: none fails.</summary>
static class EveryCall {
  static readonly Dictionary<Type, object> given = new Dictionary<Type, object>();
  internal static readonly Type[] Nouns = {
      typeof(Adjustment), typeof(Cloud), typeof(CloudBuilder), typeof(Comparer), typeof(Comparison), typeof(Evaluation), typeof(Fields), typeof(Gauge),
      typeof(JalonTask), typeof(Model), typeof(ModelEvaluation), typeof(Modeller), typeof(Network), typeof(NoiseLaw), typeof(Params), typeof(Registrar),
      typeof(Registration), typeof(Scanner), typeof(Sections), typeof(Segmentation), typeof(Segmenter), typeof(Targets), typeof(Trajectory), typeof(ArrayView), typeof(Library)};

  static IEnumerable<MethodBase> Members(Type type) {
    bool works = type.BaseType == typeof(Worker);
    return WithSetters(type).Where(m => !(works && m.IsSpecialName && m is MethodInfo));  // parameters of workers: below
  }

  internal static IEnumerable<MethodBase> WithSetters(Type type) {
    const BindingFlags all = BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;
    IEnumerable<MethodBase> methods = type.GetMethods(all).Where(m => m.ReturnType.Name != "ReadOnlySpan`1");
    return methods.Concat(type.GetConstructors()).OrderBy(m => m.ToString(), StringComparer.Ordinal);
  }

  /// <summary>The arguments: all of them, or those that must be given.</summary>
  internal static object[] Arguments(MethodBase member, object self, bool all) {
    return member.GetParameters().Select(
        p => all || !p.IsOptional ? RealValues.Of(member, p, self) : p.DefaultValue is DBNull || p.DefaultValue == null
            ? (p.ParameterType.IsValueType ? Activator.CreateInstance(p.ParameterType) : null) : p.DefaultValue).ToArray();
  }

  static string Failure(Type type, MethodBase member, bool all) {
    bool flags = type == typeof(CloudBuilder) && member.GetParameters().Any(p => p.ParameterType == typeof(bool[]));
    object self = member.IsStatic || member.IsConstructor ? null : flags ? Objects.FlagBuilder() : Objects.Subject(type, member.Name);
    var method = member as MethodInfo;
    if (method != null && method.IsGenericMethodDefinition) method = method.MakeGenericMethod(typeof(double));
    try {
      object[] arguments = Arguments(member, self, all);
      object result = method != null ? method.Invoke(self, arguments) : ((ConstructorInfo)member).Invoke(arguments);
      if (result != null) {
        Check.That(!result.ToString().Contains("Jalon."), type.Name + "." + member.Name + ": " + result + " says nothing");
        if (!given.ContainsKey(result.GetType())) given[result.GetType()] = result;
      }
      return null;
    } catch (TargetInvocationException error) {
      return member + ": " + error.InnerException.Message;
    }
  }

  public static void Members__take_real_values() {
    var failures = new List<string>();
    int calls = 0;
    foreach (Type type in Nouns) {
      foreach (MethodBase member in Members(type)) {
        foreach (bool all in new[] {true, false}) {
          string failure = NeedsOneOf(member) && !all ? null : Failure(type, member, all);
          if (failure != null) failures.Add(type.Name + ": " + failure);
          ++calls;
        }
      }
    }
    Check.That(failures.Count == 0, failures.Count + " of " + calls + " calls:\n" + string.Join("\n", failures));
    Check.That(calls > 400, calls + " calls");
  }

  /// <summary>Members one of whose optional arguments must be given.</summary>
  static bool NeedsOneOf(MethodBase member) {
    return member.Name.StartsWith("GaugeSweep");
  }

  /// <summary>What the calls gave: their values, their parts, their text.</summary>
  public static void Results__have_their_values() {
    var results = given.Where(r => r.Key.Name.EndsWith("Result")).ToArray();
    foreach (KeyValuePair<Type, object> result in results) {
      foreach (MethodBase member in Members(result.Key).Where(m => !m.IsConstructor).OrderBy(m => m.Name == "Dispose")) {
        member.Invoke(result.Value, member.GetParameters().Select(p => (object)null).ToArray());
      }
    }
    Check.That(results.Length > 15, results.Length + " classes of results");
  }

  public static void Properties_of_workers__are_their_parameters() {
    int count = 0;
    foreach (Type type in Nouns.Where(t => t.BaseType == typeof(Worker))) {
      foreach (string method in (string[])type.GetMethod("Methods").Invoke(null, null)) {
        using (var worker = (Worker)Activator.CreateInstance(type, method)) {
          string before = worker.Parameters.ToJson();
          foreach (string name in worker.Parameters.Names) {
            PropertyInfo property = type.GetProperty(Pascal(name)) ?? type.GetProperty(Pascal(name) + "Value");
            object value = property.GetValue(worker, null);
            Check.That(value.Equals(worker.Parameters.Get(name)) || value is double[], name);
            property.SetValue(worker, value, null);
            ++count;
          }
          Check.Equal(before, worker.Parameters.ToJson(), method);
        }
      }
    }
    Check.That(count > 100, count + " parameters");
  }

  static string Pascal(string name) {
    return string.Concat(name.Split('_').Select(part => part.Substring(0, 1).ToUpperInvariant() + part.Substring(1)));
  }
}
