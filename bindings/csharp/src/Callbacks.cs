// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;

namespace Jalon {

/// <summary>
/// How far a call is: fraction grows from 0 to 1, stage is a short English phrase. Return false to cancel; an exception
/// cancels too, and the call throws it. Made on the thread that called, about every 50 to 100 ms.
/// </summary>
public delegate bool Progress(double fraction, string stage);

/// <summary>One line of the log. An exception cancels, and the call throws it. Made on the thread that called.</summary>
public delegate void Log(LogLevel level, string text);

/// <summary>The delegates of a task and the exception that one of them threw in the running call.</summary>
internal sealed class Callbacks {
  [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
  internal delegate int NativeProgress(double fraction, IntPtr stage, IntPtr user);

  [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
  internal delegate int NativeLog(int level, IntPtr text, IntPtr user);

  // What csharp_support.h expects as an answer.
  private const int kGoOn = 0, kCancel = 1, kThrew = 2;

  // The two that native code calls live as long as the process; each finds its delegate by the handle in user.
  private static readonly NativeProgress on_progress = OnProgress;
  private static readonly NativeLog on_log = OnLog;

  private readonly Progress progress;
  private readonly Log log;
  private ExceptionDispatchInfo thrown;

  internal Callbacks(Progress progress, Log log) {
    this.progress = progress;
    this.log = log;
  }

  internal void Attach(Box task) {
    if (progress == null && log == null) return;
    using (var held = new Held(task)) {
      LibraryPINVOKE.set_callbacks(held.Pointer, progress == null ? null : on_progress, log == null ? null : on_log,
                                   task.Name(this));
    }
    Failure.Check();
  }

  /// <summary>Throws what a delegate threw during the call that has ended.</summary>
  internal void Rethrow() {
    ExceptionDispatchInfo kept = thrown;
    thrown = null;
    if (kept != null) kept.Throw();
  }

  private static Callbacks Of(IntPtr user) {
    return (Callbacks)GCHandle.FromIntPtr(user).Target;
  }

  private static int OnProgress(double fraction, IntPtr stage, IntPtr user) {
    Callbacks self = Of(user);
    try {
      if (self.thrown != null) return kThrew;
      return self.progress(fraction, Text.Of(stage)) ? kGoOn : kCancel;
    } catch (Exception exception) {
      return self.Keep(exception);
    }
  }

  private static int OnLog(int level, IntPtr text, IntPtr user) {
    Callbacks self = Of(user);
    try {
      if (self.thrown != null) return kThrew;
      self.log((LogLevel)level, Text.Of(text));
      return kGoOn;
    } catch (Exception exception) {
      return self.Keep(exception);
    }
  }

  private int Keep(Exception exception) {
    thrown = ExceptionDispatchInfo.Capture(exception);
    return kThrew;
  }
}

}
