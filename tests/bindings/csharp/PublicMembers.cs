// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Linq;
using System.Reflection;
using Jalon;

/// <summary>The public members of the assembly, one a line, as the trace of Mono names them without name spaces.</summary>
static class PublicMembers {
  public static void Print() {
    foreach (Type type in typeof(Cloud).Assembly.GetTypes().Where(t => t.IsPublic && !t.IsEnum && !t.IsSubclassOf(typeof(Delegate)))) {
      const BindingFlags all = BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;
      foreach (MethodBase member in type.GetMethods(all).Where(m => !m.IsAbstract).Cast<MethodBase>().Concat(type.GetConstructors())) {
        Console.WriteLine(type.Name + "." + member.Name + "(" +
                          string.Join(", ", member.GetParameters().Select(p => Text(p.ParameterType))) + ")");
      }
    }
  }

  static string Text(Type type) {
    if (type.IsByRef) return Text(type.GetElementType()) + "&";
    if (type.IsArray) return Text(type.GetElementType()) + "[" + new string(',', type.GetArrayRank() - 1) + "]";
    if (type.IsGenericType) return type.Name + "<" + string.Join(", ", type.GetGenericArguments().Select(Text)) + ">";
    switch (Type.GetTypeCode(type)) {
      case TypeCode.Boolean: return "bool";
      case TypeCode.SByte: return "sbyte";
      case TypeCode.Byte: return "byte";
      case TypeCode.Int16: return "int16";
      case TypeCode.UInt16: return "uint16";
      case TypeCode.Int32: return type.IsEnum ? type.Name : "int";
      case TypeCode.UInt32: return "uint";
      case TypeCode.Int64: return "long";
      case TypeCode.UInt64: return "ulong";
      case TypeCode.Single: return "single";
      case TypeCode.Double: return "double";
      case TypeCode.String: return "string";
      default: return type == typeof(object) ? "object" : type.Name;
    }
  }
}
