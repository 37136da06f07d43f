// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Threading;

namespace Jalon {

public sealed partial class Cloud {
  private const long kBytesPerPoint = 24;  // three doubles

  /// <summary>What the collector is told of: the coordinates, without the fields and the index.</summary>
  private static long Bytes(IntPtr box) {
    long bytes = Number.Of(LibraryPINVOKE.Cloud_count(box)) * kBytesPerPoint;
    Failure.Check();
    return bytes;
  }

  /// <summary>
  /// The points for which the mask, one a point, is true, and the others, as clouds of their own. InvalidArgumentException for
  /// a mask of another length.
  /// </summary>
  /// <param name="mask">One a point.</param>
  /// <param name="progress">Told how far each of the two copies is; may be null.</param>
  /// <param name="task">Threads, log and progress of several calls, instead of the other two.</param>
  /// <param name="cancel">Cancels the call.</param>
  public CloudCropResult Crop(bool[] mask, Progress progress = null, JalonTask task = null,
                              CancellationToken cancel = default(CancellationToken)) {
    return new CloudCropResult(Select(mask, progress, task, cancel),
                               () => Select(Masks.Inverted(mask), progress, task, cancel));
  }
}

}
