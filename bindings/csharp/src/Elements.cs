// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

/// <summary>Element types of arrays as types of .NET.</summary>
internal static class Elements {
  /// <summary>0 for what is no type of number.</summary>
  internal static ElementType TypeOf(Type element) {
    if (element == typeof(double)) return ElementType.Float64;
    if (element == typeof(float)) return ElementType.Float32;
    if (element == typeof(sbyte)) return ElementType.Int8;
    if (element == typeof(byte)) return ElementType.Uint8;
    if (element == typeof(short)) return ElementType.Int16;
    if (element == typeof(ushort)) return ElementType.Uint16;
    if (element == typeof(int)) return ElementType.Int32;
    if (element == typeof(uint)) return ElementType.Uint32;
    if (element == typeof(long)) return ElementType.Int64;
    if (element == typeof(ulong)) return ElementType.Uint64;
    return 0;
  }

  internal static Type ManagedType(ElementType type) {
    switch (type) {
      case ElementType.Int8: return typeof(sbyte);
      case ElementType.Uint8: return typeof(byte);
      case ElementType.Int16: return typeof(short);
      case ElementType.Uint16: return typeof(ushort);
      case ElementType.Int32: return typeof(int);
      case ElementType.Uint32: return typeof(uint);
      case ElementType.Int64: return typeof(long);
      case ElementType.Uint64: return typeof(ulong);
      case ElementType.Float32: return typeof(float);
      default: return typeof(double);
    }
  }

  internal static int SizeOf(ElementType type) {
    switch (type) {
      case ElementType.Int8:
      case ElementType.Uint8: return 1;
      case ElementType.Int16:
      case ElementType.Uint16: return 2;
      case ElementType.Int32:
      case ElementType.Uint32:
      case ElementType.Float32: return 4;
      default: return 8;
    }
  }

  /// <summary>One element as a double; integers above 2^53 are rounded.</summary>
  internal static unsafe double ToDouble(byte* at, ElementType type) {
    switch (type) {
      case ElementType.Int8: return *(sbyte*)at;
      case ElementType.Uint8: return *at;
      case ElementType.Int16: return *(short*)at;
      case ElementType.Uint16: return *(ushort*)at;
      case ElementType.Int32: return *(int*)at;
      case ElementType.Uint32: return *(uint*)at;
      case ElementType.Int64: return *(long*)at;
      case ElementType.Uint64: return *(ulong*)at;
      case ElementType.Float32: return *(float*)at;
      default: return *(double*)at;
    }
  }
}

}
