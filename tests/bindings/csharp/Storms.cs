// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Threading;
using Jalon;

/// <summary>What delegates throw while another thread collects without a pause: it comes out as itself, and nothing of it stays.</summary>
static class Storms {
  const int Callbacks = 500;

  sealed class Mine : Exception {
    public Mine(int i) : base("callback " + i) {}
  }

  /// <summary>Collections by another thread until Dispose.</summary>
  sealed class Storm : IDisposable {
    readonly Thread thread;
    long collections;
    bool stop;

    public Storm() {
      thread = new Thread(() => {
        while (!Volatile.Read(ref stop)) {
          GC.Collect();
          Interlocked.Increment(ref collections);
        }
      });
      thread.Start();
    }

    public long Collections {
      get { return Interlocked.Read(ref collections); }
    }

    /// <summary>Until one more is done.</summary>
    public void Wait() {
      long begin = Collections;
      while (Collections == begin) Thread.Yield();
    }

    public void Dispose() {
      Volatile.Write(ref stop, true);
      thread.Join();
    }
  }

  static bool Throw(Storm storm, Exception error) {
    storm.Wait();
    throw error;
  }

  /// <summary>A call of its own, whose delegate throws too, and then the exception.</summary>
  static bool ThrowAfterAnother(Storm storm, Exception error) {
    var inner = new Mine(-1);
    using (var small = new Cloud(Scenes.Plane(4))) {
      Mine got = Check.Throws<Mine>(() => small.ComputeNormals(progress: (fraction, stage) => Throw(storm, inner)));
      Check.That(ReferenceEquals(inner, got), "another exception of the call within");
    }
    throw error;
  }

  /// <summary>A call whose delegate throws; nothing but the call holds the delegate.</summary>
  static void Call(int kind, Cloud cloud, Storm storm, Exception error) {
    JalonTask task = null;
    if (kind == 0) {
      cloud.ComputeNormals(progress: (fraction, stage) => Throw(storm, error));
    } else if (kind == 1) {
      task = new JalonTask(1, (fraction, stage) => Throw(storm, task == null ? null : error));  // a task that its delegate keeps
      cloud.ComputeNormals(task: task);
    } else if (kind == 2) {
      task = new JalonTask(1, log: (level, text) => Throw(storm, task == null ? null : error));
      using (var segmenter = new Segmenter()) segmenter.Run(cloud, task: task);
    } else if (kind == 3) {
      cloud.Covariance(progress: (fraction, stage) => ThrowAfterAnother(storm, error));
    } else {
      using (var source = new CancellationTokenSource()) {
        cloud.KnnAll(4, progress: (fraction, stage) => {
          source.Cancel();
          return Throw(storm, error);
        }, cancel: source.Token);
      }
    }
  }

  [MethodImpl(MethodImplOptions.NoInlining)]
  static void Calls(Storm storm) {
    using (var cloud = new Cloud(Scenes.Plane(12))) {
      for (int i = 0; i < Callbacks; ++i) {
        Exception error = i / 5 % 2 == 0 ? new Mine(i) : (Exception)new OperationCanceledException("callback " + i), got = null;
        try { Call(i % 5, cloud, storm, error); } catch (Exception thrown) { got = thrown; }
        Check.That(ReferenceEquals(error, got), "callback " + i + " came out as " + got);
        Check.That(got.StackTrace.Contains("Throw"), "no trace of the delegate: " + got.StackTrace);
      }
      cloud.ComputeNormals();  // and the next call is free of it
    }
  }

  public static void What_delegates_throw__in_a_storm_of_collections_comes_out_as_itself() {
    long collections = 0, left = Lifetimes.Left(() => {
      using (var storm = new Storm()) {
        Calls(storm);
        collections = storm.Collections;
      }
    });
    Check.Equal(0L, left, "handles left");
    Check.That(collections >= Callbacks, collections + " collections");
    Console.WriteLine("FIGURE callbacks of C#: {0} of {0} came out as thrown, in {1} collections", Callbacks, collections);
  }

  public static void Task_that_its_delegate_keeps__is_collected() {
    Check.Equal(0L, Lifetimes.Left(() => {
      for (int i = 0; i < 100; ++i) {
        JalonTask task = null;
        task = new JalonTask(1, (fraction, stage) => !task.IsCancelled, (level, text) => task.Reset());
      }
    }), "handles left");
  }
}
