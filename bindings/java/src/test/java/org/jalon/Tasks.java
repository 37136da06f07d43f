// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;
import static org.jalon.Behaviours.same;
import static org.jalon.Behaviours.thrown;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;

/** Progress, log, cancel, threads. */
final class Tasks {
  private Tasks() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("tasks__progress_grows_to_one", Tasks::progress);
    all.put("tasks__an_exception_in_a_listener_comes_out_as_itself", Tasks::exception);
    all.put("tasks__false_cancels", Tasks::answersNo);
    all.put("tasks__cancel_from_another_thread", Tasks::cancel);
    all.put("tasks__close_during_a_call_is_refused", Tasks::closeDuring);
    all.put("tasks__a_collected_listener_keeps_nothing", Tasks::noCycle);
  }

  private static void progress() {
    final List<Double> seen = new ArrayList<>();
    final List<String> lines = new ArrayList<>();
    final Thread here = Thread.currentThread();
    try (Cloud cloud = Cloud.create(Behaviours.dome(1200), 0); // long enough for a report on the way
        Task task = Task.create().onProgress((fraction, stage) -> {
          expect(Thread.currentThread() == here && !stage.isEmpty(), "the thread and the stage");
          return seen.add(fraction);
        }).onLog((level, text) -> lines.add(level + text))) {
      cloud.computeNormals(null, task);
    }
    expect(seen.size() >= 2, seen + " is too little");
    for (int i = 1; i < seen.size(); ++i) {
      expect(seen.get(i) >= seen.get(i - 1), seen.toString());
    }
    same(1.0, seen.get(seen.size() - 1));
  }

  private static void exception() {
    final IllegalStateException mine = new IllegalStateException("the dialog was closed");
    try (Cloud cloud = Cloud.create(Behaviours.dome(600), 0); Task task = Task.create();
        NormalsParams slow = new NormalsParams().setK(60)) {
      task.onProgress((fraction, stage) -> {
        throw mine;
      });
      expect(thrown(IllegalStateException.class, () -> cloud.computeNormals(slow, task)) == mine, "another exception");
      thrown(NotFoundException.class, () -> cloud.fields().view("normal"));
      task.onProgress(null);
      cloud.computeNormals(null, task); // the same task goes on
      same(360000L, cloud.fields().view("normal").count());
    }
  }

  private static void answersNo() {
    try (Cloud cloud = Cloud.create(Behaviours.dome(600), 0); Task task = Task.create();
        NormalsParams slow = new NormalsParams().setK(60)) {
      task.onProgress((fraction, stage) -> false);
      same(Jalon.ERROR_CANCELLED, thrown(CancelledException.class, () -> cloud.computeNormals(slow, task)).status());
    }
  }

  /** computeNormals on a thread of its own, which waits in its first progress call until released. */
  private static final class Running {
    final Cloud cloud = Cloud.create(Behaviours.dome(1000), 0);
    final Task task = Task.create();
    final CountDownLatch started = new CountDownLatch(1);
    final CountDownLatch released = new CountDownLatch(1);
    final AtomicReference<Throwable> failure = new AtomicReference<>();
    final Thread thread = new Thread(() -> {
      try (NormalsParams options = new NormalsParams().setK(100)) {
        cloud.computeNormals(options, task);
      } catch (Throwable thrown) {
        failure.set(thrown);
      }
    });

    Running() throws InterruptedException {
      task.onProgress((fraction, stage) -> {
        started.countDown();
        try {
          released.await(20, TimeUnit.SECONDS);
        } catch (InterruptedException end) {
          return false;
        }
        return true;
      });
      thread.start();
      expect(started.await(20, TimeUnit.SECONDS), "the call did not start");
    }
  }

  private static void cancel() throws Exception {
    long best = Long.MAX_VALUE;
    long worst = 0;
    for (int i = 0; i < 5; ++i) {
      final long milliseconds = cancelled();
      best = Math.min(best, milliseconds);
      worst = Math.max(worst, milliseconds);
    }
    System.out.println("FIGURE java: a cancel from another thread ends the call after " + best + " ms, " + worst
        + " at worst");
  }

  private static long cancelled() throws Exception {
    final Running running = new Running();
    running.released.countDown();
    Thread.sleep(20); // well into the call
    final long asked = System.nanoTime();
    running.task.cancel();
    running.thread.join(20000);
    final long milliseconds = (System.nanoTime() - asked) / 1000000;
    expect(running.failure.get() instanceof CancelledException, String.valueOf(running.failure.get()));
    expect(running.task.isCancelled(), "cancelled until reset");
    running.cloud.close();
    running.task.close();
    return milliseconds;
  }

  private static void closeDuring() throws Exception {
    final Running running = new Running();
    expect(thrown(BusyException.class, running.cloud::close).getMessage().contains("cloud"), "the noun");
    thrown(BusyException.class, running.task::close);
    try (Cloud other = Cloud.create(Behaviours.dome(10), 0)) {
      thrown(BusyException.class, () -> other.prepare(running.task));
    }
    running.task.cancel();
    running.released.countDown();
    running.thread.join(20000);
    running.cloud.close();
    expect(running.cloud.isClosed(), "closed after the call");
    running.task.close();
  }

  private static void noCycle() throws Exception {
    Lifetimes.settle();
    final long before = Jalon.liveHandleCount();
    for (int i = 0; i < 100; ++i) {
      final Task task = Task.create();
      task.onProgress((fraction, stage) -> !task.isCancelled());
    }
    Lifetimes.settleTo(before);
  }
}
