// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

/// <summary>What the last call of this thread left behind.</summary>
internal static class Failure {
  /// <summary>Beside the statuses of the library: the object was closed (handles.h).</summary>
  private const int kClosed = -1000;

  /// <summary>Throws when the last call of this thread failed.</summary>
  internal static void Check() {
    int status = LibraryPINVOKE.last_status();
    if (status != 0) throw Of(status, Text.Of(LibraryPINVOKE.take_message()));
  }

  /// <summary>The failure of the last call, which is forgotten; null when it succeeded.</summary>
  internal static Exception Take() {
    int status = LibraryPINVOKE.last_status();
    return status == 0 ? null : Of(status, Text.Of(LibraryPINVOKE.take_message()));
  }

  private static Exception Of(int status, string message) {
    switch (status) {
      case kClosed: return new ObjectDisposedException(null, message);
      case (int)Status.ErrorInvalidArgument: return new InvalidArgumentException(message);
      case (int)Status.ErrorOutOfMemory: return new NativeMemoryException(message);
      case (int)Status.ErrorCancelled: return new OperationCanceledException(message);
      case (int)Status.ErrorNotFound: return new NotFoundException(message);
      case (int)Status.ErrorInsufficientData: return new InsufficientDataException(message);
      case (int)Status.ErrorDegenerate: return new DegenerateException(message);
      case (int)Status.ErrorIo: return new FileAccessException(message);
      case (int)Status.ErrorFormat: return new FileFormatException(message);
      case (int)Status.ErrorUnsupported: return new UnsupportedException(message);
      case (int)Status.ErrorBusy: return new BusyException(message);
      case (int)Status.ErrorLimit: return new LimitException(message);
      default: return new JalonException((Status)status, message);
    }
  }
}

}
