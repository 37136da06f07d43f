// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

public sealed partial class Cloud {
  private const long kBytesPerPoint = 24;  // three doubles

  /// <summary>What the collector is told of: the coordinates, without the fields and the index.</summary>
  private static long Bytes(IntPtr box) {
    long bytes = Number.Of(LibraryPINVOKE.Cloud_count(box)) * kBytesPerPoint;
    Failure.Check();
    return bytes;
  }
}

}
