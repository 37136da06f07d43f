// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.InteropServices;

namespace Jalon {

/// <summary>A call of Jalon failed; the message is one helpful line.</summary>
public class JalonException : Exception {
  internal JalonException(int status, string message) : base(message) {
    Code = status;
  }

  /// <summary>The status of the C library, one of the ERROR_ constants of <see cref="Library"/>.</summary>
  public int Code { get; private set; }
}

/// <summary>What the last call of this thread left behind.</summary>
internal static class Status {
  [DllImport("jalon_csharp", EntryPoint = "jalon_csharp_status")]
  private static extern int Last();

  [DllImport("jalon_csharp", EntryPoint = "jalon_csharp_take_message")]
  private static extern IntPtr TakeMessage();

  internal static bool Pending {
    get { return Last() != 0; }
  }

  internal static Exception Take() {
    int status = Last();
    return new JalonException(status, Text.Of(TakeMessage()));
  }
}

}
