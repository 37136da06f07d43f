// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

/// <summary>
/// A call of Jalon failed; the message is one helpful line. Two failures have .NET's own classes instead: a cancelled
/// call throws OperationCanceledException, an object used after Dispose ObjectDisposedException.
/// </summary>
public class JalonException : Exception {
  internal JalonException(Status status, string message) : base(message) {
    Status = status;
  }

  /// <summary>The status of the C library.</summary>
  public Status Status { get; private set; }
}

/// <summary>An argument is null, out of range, of an unknown name or of the wrong size.</summary>
public sealed class InvalidArgumentException : JalonException {
  internal InvalidArgumentException(string message) : base(Status.ErrorInvalidArgument, message) {}
}

/// <summary>Native memory could not be had; nothing was changed.</summary>
public sealed class NativeMemoryException : JalonException {
  internal NativeMemoryException(string message) : base(Status.ErrorOutOfMemory, message) {}
}

/// <summary>No such file, field, parameter or station.</summary>
public sealed class NotFoundException : JalonException {
  internal NotFoundException(string message) : base(Status.ErrorNotFound, message) {}
}

/// <summary>Too few points for the work.</summary>
public sealed class InsufficientDataException : JalonException {
  internal InsufficientDataException(string message) : base(Status.ErrorInsufficientData, message) {}
}

/// <summary>Collinear, all equal, no plane: geometry without a solution.</summary>
public sealed class DegenerateException : JalonException {
  internal DegenerateException(string message) : base(Status.ErrorDegenerate, message) {}
}

/// <summary>The system refused to open, read, write or rename a file.</summary>
public sealed class FileAccessException : JalonException {
  internal FileAccessException(string message) : base(Status.ErrorIo, message) {}
}

/// <summary>A file's content is malformed or truncated.</summary>
public sealed class FileFormatException : JalonException {
  internal FileFormatException(string message) : base(Status.ErrorFormat, message) {}
}

/// <summary>Valid, but not handled by this build.</summary>
public sealed class UnsupportedException : JalonException {
  internal UnsupportedException(string message) : base(Status.ErrorUnsupported, message) {}
}

/// <summary>The task already runs a call, or a running call uses the object.</summary>
public sealed class BusyException : JalonException {
  internal BusyException(string message) : base(Status.ErrorBusy, message) {}
}

/// <summary>More than the library or an array of .NET can index or hold.</summary>
public sealed class LimitException : JalonException {
  internal LimitException(string message) : base(Status.ErrorLimit, message) {}
}

}
