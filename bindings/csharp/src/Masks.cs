// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
namespace Jalon {

/// <summary>Masks of points: one a point, true for those that are meant.</summary>
internal static class Masks {
  /// <summary>The indices of those that are true; none for null. The mask must be of so many points.</summary>
  internal static ArrayArgument Indices(bool[] mask, long points) {
    if (mask == null) return default(ArrayArgument);
    if (mask.LongLength != points) {
      throw new InvalidArgumentException("the mask has " + mask.LongLength + " items, the cloud has " + points + " points");
    }
    long count = 0;
    foreach (bool meant in mask) count += meant ? 1 : 0;
    var indices = new long[count];
    long at = 0;
    for (long i = 0; i < mask.LongLength; ++i) {
      if (mask[i]) indices[at++] = i;
    }
    return indices;
  }

  /// <summary>The same; one that means no point is refused, because no indices stand for all points there.</summary>
  internal static ArrayArgument Some(bool[] mask, long points) {
    ArrayArgument indices = Indices(mask, points);
    if (mask != null && indices.Managed.LongLength == 0) throw new InsufficientDataException("the mask means no point");
    return indices;
  }

  internal static bool[] Inverted(bool[] mask) {
    var others = new bool[mask.LongLength];
    for (long i = 0; i < mask.LongLength; ++i) others[i] = !mask[i];
    return others;
  }

  /// <summary>0 and 1; none for null.</summary>
  internal static ArrayArgument Flags(bool[] flags) {
    if (flags == null) return default(ArrayArgument);
    var bytes = new byte[flags.LongLength];
    for (long i = 0; i < flags.LongLength; ++i) bytes[i] = (byte)(flags[i] ? 1 : 0);
    return bytes;
  }
}

}
