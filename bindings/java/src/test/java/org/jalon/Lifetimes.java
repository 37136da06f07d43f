// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;

import java.io.IOException;
import java.nio.DoubleBuffer;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;

/** Create, use and drop, with and without close, under a storm of collections: no crash, no handle and no memory stays. */
final class Lifetimes {
  private static final int CYCLES = "1".equals(System.getenv("JALON_FULL")) ? 10000 : 500;
  private static final int CLOSES = CYCLES > 500 ? 1000 : 200;
  private static final double LIMIT_MIB = 8;

  private Lifetimes() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("lifetimes__closed_in_order", () -> storm("closed", i -> true));
    all.put("lifetimes__never_closed", () -> storm("dropped", i -> false));
    all.put("lifetimes__half_closed_in_any_order", () -> storm("half closed", i -> i % 3 == 0));
    all.put("lifetimes__many_threads", Lifetimes::threads);
    all.put("lifetimes__closes_race_with_calls", Lifetimes::closes);
  }

  /** Whether cycle i closes object number i. */
  interface Closing {
    boolean now(int i);
  }

  /** One of everything; what is not closed is dropped here. Returns a view that outlives its owners. */
  private static DoubleBuffer cycle(int n, Closing closing) {
    final List<AutoCloseable> made = new ArrayList<>();
    final Cloud cloud = Cloud.create(new double[] {n, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 0);
    final Array points = cloud.points();
    final DoubleBuffer view = points.doubles();
    final Task task = Task.create().onProgress((fraction, stage) -> true);
    cloud.prepare(task);
    cloud.setField("n", new int[] {n, n, n, n}, "", "");
    final Fields fields = cloud.fields();
    final CloudCropBoxResult halves = cloud.cropBox(new double[] {-1, -1, -1, 0.5, 2, 2}, task);
    final Segmenter segmenter = Segmenter.create("ransac").set("min_points", 3);
    final Params params = segmenter.params();
    expect(fields.doubles("n")[3] == n && params.getInt64("min_points") == 3, "the values");
    for (AutoCloseable one : new AutoCloseable[] {cloud, points, task, fields, halves, segmenter, params}) {
      made.add(n % 2 == 0 ? made.size() : 0, one);
    }
    for (int i = 0; i < made.size(); ++i) {
      if (closing.now(n + i)) {
        try {
          made.get(i).close();
        } catch (Exception failure) {
          throw new AssertionError(failure);
        }
      }
    }
    return view;
  }

  private static void cycles(int count, Closing closing) {
    final DoubleBuffer[] views = new DoubleBuffer[16];
    for (int i = 0; i < count; ++i) {
      views[i % views.length] = cycle(i, closing);
      if (i >= 8) {
        expect(views[(i - 8) % views.length].get(0) == i - 8, "a view has lost its memory");
      }
      if (i % 50 == 49) {
        System.gc();
      }
    }
  }

  private static void storm(String name, Closing closing) throws Exception {
    settle();
    final long before = Jalon.liveHandleCount();
    cycles(Math.max(500, CYCLES / 4), closing); // warm-up: classes, compiled code, the compiler's and the allocator's arenas
    settleTo(before);
    // What leaks comes again in each round; what the compiler takes for its own work, when it gets to it, does not.
    double grown = LIMIT_MIB;
    for (int round = 0; round < 3 && grown >= LIMIT_MIB; ++round) {
      final double warm = residentMib();
      cycles(CYCLES, closing);
      settleTo(before);
      grown = residentMib() - warm;
    }
    System.out.printf(java.util.Locale.ROOT, "FIGURE java: %d cycles, %s: RSS grows by %.1f MiB, no handle stays%n",
        CYCLES, name, grown);
    expect(grown < LIMIT_MIB, grown + " MiB");
  }

  private static void threads() throws Exception {
    settle();
    final long before = Jalon.liveHandleCount();
    final List<Throwable> failures = new ArrayList<>();
    final List<Thread> threads = new ArrayList<>();
    for (int t = 0; t < 4; ++t) {
      final int own = t;
      final Thread thread = new Thread(() -> {
        try {
          cycles(CYCLES / 10, i -> (i + own) % 2 == 0);
        } catch (Throwable failure) {
          synchronized (failures) {
            failures.add(failure);
          }
        }
      });
      threads.add(thread);
      thread.start();
    }
    for (Thread thread : threads) {
      thread.join();
    }
    expect(failures.isEmpty(), failures.toString());
    threads.clear();
    settleTo(before);
  }

  /** Closes while another thread calls: each ends well or is refused, whichever comes first. */
  private static void closes() throws Exception {
    settle();
    final long before = Jalon.liveHandleCount();
    final AtomicInteger done = new AtomicInteger();
    final AtomicInteger refused = new AtomicInteger();
    int closed = 0;
    final ExecutorService other = Executors.newSingleThreadExecutor();
    try {
      for (int i = 0; i < CLOSES; ++i) {
        final Cloud cloud = Cloud.create(Behaviours.dome(16), 0);
        final CountDownLatch began = new CountDownLatch(1);
        final Future<?> calls = other.submit(() -> {
          began.countDown();
          for (int k = 0; k < 12; ++k) {
            try {
              cloud.computeNormals();
              done.incrementAndGet();
            } catch (ClosedException failure) {
              refused.incrementAndGet();
            }
            if (k % 4 == 3) {
              Thread.sleep(1); // room for a close between two calls, which follow each other at once where code is warm
            }
          }
          return null;
        });
        began.await();
        Thread.sleep(i % 3);
        try {
          cloud.close();
          ++closed;
        } catch (BusyException failure) {
          expect(!cloud.isClosed(), "it stays open");
        }
        calls.get();
        cloud.close();
      }
    } finally {
      other.shutdown();
    }
    settleTo(before);
    System.out.println("FIGURE java: closes that race with calls: " + closed + " of " + CLOSES + " closed, " + (CLOSES - closed) + " busy; " + done
        + " calls done, " + refused + " refused");
    expect(closed > 0 && done.get() > 0 && refused.get() > 0 && done.get() + refused.get() == 12 * CLOSES, "each is one of them");
  }

  /** Collects until the number of handles no longer falls. */
  static void settle() throws InterruptedException {
    long last = -1;
    for (int same = 0; same < 3;) {
      System.gc();
      Thread.sleep(20);
      final long now = Jalon.liveHandleCount();
      same = now == last ? same + 1 : 0;
      last = now;
    }
  }

  static void settleTo(long wanted) throws InterruptedException {
    for (int i = 0; i < 500 && Jalon.liveHandleCount() > wanted; ++i) {
      System.gc();
      Thread.sleep(20);
    }
    expect(Jalon.liveHandleCount() <= wanted, (Jalon.liveHandleCount() - wanted) + " handles stay");
  }

  /** Of this process; 0 where the system does not say. */
  private static double residentMib() throws IOException {
    if (!Files.exists(Paths.get("/proc/self/statm"))) {
      return 0;
    }
    return Long.parseLong(Files.readString(Paths.get("/proc/self/statm")).split(" ")[1]) * 4096.0 / (1 << 20);
  }
}
