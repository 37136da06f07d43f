// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.IO;
using System.Runtime.CompilerServices;
using System.Threading;
using Jalon;

static class Lifetimes {
  static int Cycles {
    get { return Check.Full ? 10000 : 500; }
  }

  /// <summary>Resident bytes of this process (Linux).</summary>
  static double ResidentMiB() {
    foreach (string line in File.ReadAllLines("/proc/self/status")) {
      if (line.StartsWith("VmRSS:")) return double.Parse(line.Substring(6).Replace("kB", "").Trim()) / 1024;
    }
    return 0;
  }

  /// <summary>Until finalisers have nothing left to free.</summary>
  static long Settled() {
    for (int i = 0; i < 20 && Library.LiveHandleCount != 0; ++i) {
      Overwrite(200);
      GC.Collect();
      GC.WaitForPendingFinalizers();
    }
    return Library.LiveHandleCount;
  }

  /// <summary>The collector of Mono scans the stack conservatively: what lies there of finished calls goes.</summary>
  [MethodImpl(MethodImplOptions.NoInlining)]
  static int Overwrite(int depth) {
    return depth == 0 ? 0 : Overwrite(depth - 1) + 1;
  }

  /// <summary>Handles that stay of what was done on a thread of its own: its stack goes with it.</summary>
  internal static long Left(Action action) {
    long before = Settled();
    Exception failure = null;
    var worker = new Thread(() => { try { action(); } catch (Exception thrown) { failure = thrown; } });
    worker.Start();
    worker.Join();
    if (failure != null) throw failure;
    return Settled() - before;
  }

  static readonly double[,] plane = Scenes.Plane(12);

  [MethodImpl(MethodImplOptions.NoInlining)]
  static void UseAndDispose() {
    using (var cloud = new Cloud(plane))
    using (var segmenter = new Segmenter { DistanceToleranceM = 0.02 })
    using (var options = new NormalsOptions { K = 8 })
    using (var task = new JalonTask(1, (fraction, stage) => true)) {
      cloud.ComputeNormals(options, task: task);
      using (Segmentation segmentation = segmenter.Run(cloud, task: task))
      using (Fields segments = segmentation.GetSegments())
      using (ArrayView area = segments["area"]) Check.That(area.Count >= 0, "area");
      using (CloudKnnResult near = cloud.Knn(new double[] {0, 0, 0}, 3)) Check.Equal(3L, near.Indices.Length, "near");
    }
  }

  /// <summary>Objects that nothing closes, the owner dropped before what looks at it and after.</summary>
  [MethodImpl(MethodImplOptions.NoInlining)]
  static void UseAndDrop(int i) {
    var cloud = new Cloud(plane);
    ArrayView points = cloud.GetPoints();
    Fields fields = cloud.GetFields();
    var segmentation = new Segmenter { DistanceToleranceM = 0.02 }.Run(cloud, progress: (fraction, stage) => true);
    ArrayView area = segmentation.GetSegments()["area"];
    CloudKnnResult near = cloud.Knn(points, 2);
    if (i % 3 == 0) cloud.Dispose();
    if (i % 5 == 0) area.Dispose();
    Check.Equal(144L, points.Count, "points");
    GC.KeepAlive(fields);
    GC.KeepAlive(near);
  }

  // Warm once Mono's nursery of 4 MB was full and collected: after some 2500 cycles in which nothing is disposed of. In
  // the long run as many as are then looked at: of what nobody disposes of a fifth waits for the collector all the
  // while, and the C library's heap stays as large as it needed.
  static int WarmCycles {
    get { return Math.Max(3000, Cycles); }
  }

  static void Repeat(string how, Action<int> cycle) {
    var helper = new Thread(() => { for (int i = 0; i < WarmCycles; ++i) cycle(i); });  // a stack of its own, which goes with it
    helper.Start();
    helper.Join();
    Settled();
    double warm = ResidentMiB();
    var worker = new Thread(() => { for (int i = 0; i < Cycles; ++i) cycle(i); });
    worker.Start();
    worker.Join();
    long left = Settled();
    double grown = ResidentMiB() - warm;
    Check.Figure(string.Format("{0} cycles {1}: {2} handles left, {3:F1} MiB grown", Cycles, how, left, grown));
    Check.Equal(0L, left, "handles left");
    Check.That(grown < 8, grown + " MiB grown");
  }

  public static void Cycles__with_dispose() {
    Repeat("with Dispose", i => UseAndDispose());
  }

  public static void Cycles__without_dispose() {
    Repeat("without Dispose", i => UseAndDrop(i));
  }

  public static void Cycles__in_a_storm_of_collections() {
    bool stop = false;
    var storm = new Thread(() => {
      while (!Volatile.Read(ref stop)) {
        GC.Collect();
        Thread.Sleep(1);
      }
    });
    storm.Start();
    try {
      Repeat("in a storm", i => { if (i % 2 == 0) UseAndDispose(); else UseAndDrop(i); });
    } finally {
      Volatile.Write(ref stop, true);
      storm.Join();
    }
  }

  public static void Dispose__twice_is_harmless_and_use_after_it_throws() {
    var cloud = new Cloud(plane);
    Fields fields = cloud.GetFields();
    var segmenter = new Segmenter();
    cloud.Dispose();
    cloud.Dispose();
    segmenter.Dispose();
    Check.That(cloud.IsDisposed && !fields.IsDisposed, "IsDisposed");
    Check.Throws<ObjectDisposedException>(() => { long count = cloud.Count; });
    Check.Throws<ObjectDisposedException>(() => new Segmenter().Run(cloud));
    Check.Throws<ObjectDisposedException>(() => segmenter.DistanceToleranceM = 1);
    Check.Equal(0L, fields.Count, "a snapshot stays");
    fields.Dispose();
  }

  public static void Dispose_during_a_call__throws_and_the_call_ends_well() {
    using (var cloud = new Cloud(Scenes.Plane(1100))) {
      Exception got = null;
      cloud.ComputeNormals(progress: (fraction, stage) => {
        var other = new Thread(() => { try { cloud.Dispose(); } catch (Exception error) { got = error; } });
        other.Start();
        other.Join();
        return true;
      });
      Check.That(got is BusyException, "expected BusyException, got " + got);
      using (Fields fields = cloud.GetFields()) Check.Equal(1L, fields.Count, "the call's field");
    }
  }

  public static void Dispose__races_with_calls_and_never_crashes() {
    Exception wrong = null;
    for (int round = 0; round < (Check.Full ? 2000 : 1000); ++round) {
      var cloud = new Cloud(plane);
      ArrayView points = cloud.GetPoints();
      var user = new Thread(() => {
        try {
          for (int i = 0; i < 50; ++i) GC.KeepAlive(cloud.Count + (long)points[i]);
        } catch (ObjectDisposedException) {
        } catch (Exception error) { wrong = error; }
      });
      user.Start();
      try { cloud.Dispose(); } catch (BusyException) {}
      points.Dispose();
      user.Join();
      cloud.Dispose();
    }
    if (wrong != null) throw wrong;
  }
}
