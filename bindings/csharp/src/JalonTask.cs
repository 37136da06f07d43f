// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Runtime.CompilerServices;
using System.Threading;

namespace Jalon {

public sealed partial class JalonTask {
  private readonly Callbacks callbacks;

  /// <summary>A task for calls one after the other.</summary>
  /// <param name="threads">1 to 256, or 0 for all processors. The result never depends on it.</param>
  /// <param name="progress">May be null. The task keeps it.</param>
  /// <param name="log">May be null. The task keeps it.</param>
  public JalonTask(long threads = 0, Progress progress = null, Log log = null) : this(Loader.Load() ? Made() : IntPtr.Zero) {
    callbacks = new Callbacks(progress, log);
    callbacks.Attach(Live());
    if (threads != 0) SetThreads(threads);
  }

  [MethodImpl(MethodImplOptions.NoInlining)]
  private static IntPtr Made() {
    IntPtr task = LibraryPINVOKE.Task_create();
    Failure.Check();
    return task;
  }

  internal Callbacks Callbacks {
    get { return callbacks; }
  }
}

/// <summary>What one call runs with: the task it was given, or one of its own.</summary>
internal sealed class Run : IDisposable {
  private readonly JalonTask task;
  private readonly bool own;
  private readonly CancellationToken cancel;
  private readonly CancellationTokenRegistration registration;
  private readonly Held held;

  internal Run(Progress progress, JalonTask given, CancellationToken cancel) {
    if (given != null && (progress != null || cancel.CanBeCanceled)) {
      throw new InvalidArgumentException("give a task or progress and cancel, not both: a task has its own");
    }
    own = progress != null || cancel.CanBeCanceled;
    task = own ? new JalonTask(0, progress) : given;
    this.cancel = cancel;
    held = new Held(Noun.Of(task));
    if (cancel.CanBeCanceled) registration = cancel.Register(task.Cancel);
  }

  /// <summary>The native task, which stays until Dispose.</summary>
  internal IntPtr Pointer {
    get { return held.Pointer; }
  }

  /// <summary>Throws what a delegate threw, or the failure of the call.</summary>
  internal void Check() {
    Exception failure = Failure.Take();
    if (task != null) task.Callbacks.Rethrow();
    if (failure == null) return;
    if (failure is OperationCanceledException && cancel.IsCancellationRequested) {
      throw new OperationCanceledException(failure.Message, cancel);
    }
    throw failure;
  }

  public void Dispose() {
    registration.Dispose();  // waits for a cancel under way
    held.Dispose();
    if (own) task.Dispose();
  }
}

}
