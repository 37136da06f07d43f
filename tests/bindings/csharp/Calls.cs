// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Jalon;

static class Calls {
  sealed class Mine : Exception {}

  /// <summary>Normals of so many points take long enough for several reports on the way.</summary>
  static Cloud Large() {
    return new Cloud(Scenes.Plane(1100));
  }

  public static void Progress__grows_to_one() {
    double last = -1;
    bool grows = true;
    int thread = Thread.CurrentThread.ManagedThreadId, calls = 0;
    using (Cloud cloud = Large()) {
      cloud.ComputeNormals(progress: (fraction, stage) => {
        grows = grows && fraction >= last && stage.Length > 0 && Thread.CurrentThread.ManagedThreadId == thread;
        last = fraction;
        ++calls;
        GC.Collect();  // the delegate must live through it
        return true;
      });
    }
    Check.That(grows && calls > 1, "the fraction fell, or the call came from another thread");
    Check.Equal(1.0, last, "the last fraction");
  }

  public static void Exception_in_progress__surfaces_as_itself() {
    var mine = new Mine();
    using (Cloud cloud = Large()) {
      Mine got = Check.Throws<Mine>(() => cloud.ComputeNormals(progress: (fraction, stage) => { throw mine; }));
      Check.That(ReferenceEquals(mine, got), "another exception of the same type");
      Check.That(got.StackTrace.Contains("ComputeNormals"), "no trace of the call");
      cloud.ComputeNormals();  // and the next call is free of it
    }
  }

  public static void Exception_in_log__surfaces_as_itself() {
    using (var task = new JalonTask(log: (level, text) => { throw new Mine(); }))
    using (var cloud = new Cloud(Scenes.Plane(200)))
    using (var segmenter = new Segmenter()) {
      Check.Throws<Mine>(() => segmenter.Run(cloud, task: task));
    }
  }

  public static void False_in_progress__cancels() {
    using (Cloud cloud = Large()) {
      Check.Throws<OperationCanceledException>(() => cloud.ComputeNormals(progress: (fraction, stage) => false));
      using (Fields fields = cloud.GetFields()) Check.Equal(0L, fields.Count, "fields after a cancelled call");
    }
  }

  public static void Cancel_from_another_thread__ends_the_call() {
    using (var started = new AutoResetEvent(false))
    using (var task = new JalonTask(1, (fraction, stage) => { started.Set(); return true; }))
    using (var cloud = new Cloud(Scenes.Plane(1500))) {
      var took = new long[5];
      for (int i = 0; i < took.Length; ++i) took[i] = Cancelled(cloud, task, started);
      Check.Figure(string.Format("cancel ends a call after {0} ms, {1} at worst", took.Min(), took.Max()));
      using (var small = new Cloud(Scenes.Plane(10))) small.ComputeNormals(task: task);
    }
  }

  static long Cancelled(Cloud cloud, JalonTask task, AutoResetEvent started) {
    started.Reset();
    var clock = new Stopwatch();
    var other = new Thread(() => { started.WaitOne(); clock.Start(); task.Cancel(); });
    other.Start();
    Check.Throws<OperationCanceledException>(() => { while (true) cloud.ComputeNormals(task: task); });
    clock.Stop();
    other.Join();
    Check.That(task.IsCancelled, "the task does not say so");
    task.Reset();
    return clock.ElapsedMilliseconds;
  }

  public static void CancellationToken__cancels_and_is_told() {
    using (var source = new CancellationTokenSource())
    using (Cloud cloud = Large()) {
      var error = Check.Throws<OperationCanceledException>(() => cloud.ComputeNormals(
          progress: (fraction, stage) => { source.Cancel(); return true; }, cancel: source.Token));
      Check.Equal(source.Token, error.CancellationToken, "token");
      Check.Throws<OperationCanceledException>(() => cloud.ComputeNormals(cancel: source.Token));
    }
  }

  public static void Task__runs_one_call_at_a_time() {
    using (Cloud cloud = Large()) {
      JalonTask task = null;
      Exception busy = null;
      task = new JalonTask(0, (fraction, stage) => {
        try { cloud.Covariance(task: task); } catch (BusyException error) { busy = error; }
        return true;
      });
      cloud.ComputeNormals(task: task);
      Check.That(busy != null, "a second call with the same task");
      Check.Throws<InvalidArgumentException>(() => cloud.Covariance(progress: (f, s) => true, task: task));
      task.Dispose();
    }
  }

  public static void Log__tells_lines() {
    int lines = 0;
    using (var task = new JalonTask(log: (level, text) => { if (text.Length > 0 && level >= LogLevel.Debug) ++lines; }))
    using (var cloud = new Cloud(Scenes.Plane(200)))
    using (var segmenter = new Segmenter())
    using (segmenter.Run(cloud, task: task)) Check.That(lines > 0, "no line");
  }

  public static void Failures__have_their_class_and_status() {
    using (var cloud = new Cloud(new double[3])) {
      Check.Equal(Status.ErrorNotFound, Check.Throws<NotFoundException>(() => Cloud.Read("/nowhere/none.las")).Status, "read");
      Check.Throws<NotFoundException>(() => cloud.RemoveField("none"));
      using (var segmenter = new Segmenter()) Check.Throws<InsufficientDataException>(() => segmenter.Run(cloud));
      using (var segmenter = new Segmenter()) {
        Check.Equal("cloud is null", Check.Throws<InvalidArgumentException>(() => segmenter.Run(null)).Message, "no cloud");
      }
      using (var line = new Cloud(new double[] {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3}))
      using (var segmenter = new Segmenter()) Check.Throws<DegenerateException>(() => segmenter.Run(line));
      Check.Throws<UnsupportedException>(() => cloud.Write("cloud.unknownformat"));
    }
  }

  public static void Threads__have_failures_of_their_own() {
    Exception failure = null;
    var threads = new Thread[8];
    for (int t = 0; t < threads.Length; ++t) {
      int own = t;
      threads[t] = new Thread(() => {
        try {
          for (int i = 0; i < 200; ++i) {
            string name = "field" + own;
            using (var cloud = new Cloud(new double[3])) {
              string message = Check.Throws<NotFoundException>(() => cloud.RemoveField(name)).Message;
              Check.That(message.Contains(name), message);
            }
          }
        } catch (Exception error) { failure = error; }
      });
      threads[t].Start();
    }
    foreach (Thread thread in threads) thread.Join();
    if (failure != null) throw failure;
  }
}
