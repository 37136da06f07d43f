// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

/// <summary>
/// Counts and indices are long in .NET and unsigned in C. "None", the largest unsigned number there, is -1 here.
/// </summary>
internal static class Number {
  internal static uint UInt32(long value, string name) {
    if (value == -1) return uint.MaxValue;
    if (value >= 0 && value <= uint.MaxValue) return (uint)value;
    throw new InvalidArgumentException(name + " must be from 0 to " + uint.MaxValue + ", not " + value);
  }

  internal static ulong UInt64(long value, string name) {
    if (value >= -1) return unchecked((ulong)value);
    throw new InvalidArgumentException(name + " must not be negative, " + value + " is");
  }

  internal static long Of(ulong value) {
    if (value <= long.MaxValue || value == ulong.MaxValue) return unchecked((long)value);
    throw new LimitException(value + " is above 2^63 - 1");
  }
}

}
