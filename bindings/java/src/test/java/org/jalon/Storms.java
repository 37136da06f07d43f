// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import static org.jalon.Behaviours.expect;
import static org.jalon.Behaviours.thrown;

import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;

/** What listeners throw while another thread collects without a pause: it comes out as itself, and nothing of it stays. */
final class Storms {
  private static final int CALLBACKS = 500;

  private Storms() {}

  static void addTo(Map<String, Behaviours.Body> all) {
    all.put("storms__what_listeners_throw_comes_out_as_itself", Storms::callbacks);
  }

  private static final class Mine extends RuntimeException {
    private static final long serialVersionUID = 1;

    Mine(String message) {
      super(message);
    }
  }

  /** As an OutOfMemoryError of the listener would be. */
  private static final class MineToo extends Error {
    private static final long serialVersionUID = 1;

    MineToo(String message) {
      super(message);
    }
  }

  /** Collections by another thread until close. */
  private static final class Storm implements AutoCloseable {
    final AtomicLong collections = new AtomicLong();
    private volatile boolean stop;
    private final Thread thread = new Thread(() -> {
      while (!stop) {
        System.gc();
        collections.incrementAndGet();
      }
    });

    Storm() {
      thread.start();
    }

    /** Until one more is done. */
    void await() {
      final long begin = collections.get();
      while (collections.get() == begin) {
        Thread.yield();
      }
    }

    @Override
    public void close() {
      stop = true;
      try {
        thread.join();
      } catch (InterruptedException failure) {
        throw new IllegalStateException(failure);
      }
    }
  }

  private static boolean fail(Storm storm, Throwable error) {
    if (error instanceof Error || storm.collections.get() == 0) {
      storm.await(); // half of them: a collection takes as long as all else
    }
    if (error instanceof Error) {
      throw (Error) error;
    }
    throw (RuntimeException) error;
  }

  /** A call of its own, whose listener throws too, and then the failure. */
  private static boolean failAfterAnother(Storm storm, Throwable error) {
    final Mine inner = new Mine("of the call within");
    try (Cloud small = Cloud.create(Behaviours.dome(4), 0)) {
      final Task task = Task.create().onProgress((fraction, stage) -> fail(storm, inner));
      expect(thrown(Mine.class, () -> small.computeNormals(null, task)) == inner, "another exception of the call within");
    }
    return fail(storm, error);
  }

  /** A call whose listener throws; nothing but the call's task holds the listener. */
  private static void call(int kind, Cloud cloud, Storm storm, Throwable error) {
    final Task task = Task.create();
    if (kind == 0) {
      cloud.computeNormals(null, task.onProgress((fraction, stage) -> fail(storm, error)));
    } else if (kind == 1) {
      cloud.prepare(task.onProgress((fraction, stage) -> fail(storm, task.isCancelled() ? null : error))); // which keeps its task
    } else if (kind == 2) {
      try (Segmenter segmenter = Segmenter.create("ransac")) {
        segmenter.run(cloud, task.onLog((level, text) -> fail(storm, error)));
      }
    } else {
      cloud.knnAll(4, task.onProgress((fraction, stage) -> failAfterAnother(storm, error)));
    }
  }

  private static void callbacks() throws Exception {
    Lifetimes.settle();
    final long before = Jalon.liveHandleCount();
    final long collections;
    try (Storm storm = new Storm(); Cloud cloud = Cloud.create(Behaviours.dome(12), 0)) {
      for (int i = 0; i < CALLBACKS; ++i) {
        final Throwable error = i / 4 % 2 == 0 ? new Mine("callback " + i) : new MineToo("callback " + i);
        final int kind = i % 4;
        expect(thrown(Throwable.class, () -> call(kind, cloud, storm, error)) == error, "callback " + i + " is another exception");
        expect(error.getStackTrace()[0].getMethodName().equals("callbacks"), "the trace is its own");
      }
      cloud.computeNormals(); // and the next call is free of it
      collections = storm.collections.get();
    }
    Lifetimes.settleTo(before);
    expect(collections >= CALLBACKS / 3, collections + " collections");
    System.out.println("FIGURE callbacks of Java: " + CALLBACKS + " of " + CALLBACKS + " came out as thrown, in " + collections
        + " collections");
  }
}
