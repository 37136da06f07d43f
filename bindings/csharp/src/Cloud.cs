// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

public sealed partial class Cloud {
  private const long kBytesPerPoint = 24;  // three doubles

  /// <summary>What the collector is told of: the coordinates, without the fields and the index.</summary>
  private static long Bytes(IntPtr box) {
    using (var look = new Look(box)) {
      long bytes = Number.Of(LibraryPINVOKE.Cloud_count(look)) * kBytesPerPoint;
      Failure.Check();
      return bytes;
    }
  }

  /// <summary>A box that is looked at and not taken over.</summary>
  private sealed class Look : Box {
    internal Look(IntPtr box) : base(box, 0) {}
    protected override void Delete(IntPtr box) {}
  }
}

}
