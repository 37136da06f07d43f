// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

import java.lang.ref.Cleaner;
import java.lang.ref.Reference;
import java.util.List;

/**
 * An object of the native library. {@link #close()} gives its memory back now, and again and again without harm; what is
 * not closed goes when the garbage collector finds it, some time later. There is no finalizer.
 *
 * <p>A call with a closed object throws {@link ClosedException}; close() while another thread's call uses the object
 * throws {@link BusyException}, and the object stays open.
 */
public abstract class NativeObject implements AutoCloseable {
  private static final Cleaner CLEANER = Cleaner.create();

  private Cleaner.Cleanable cleanable;

  NativeObject() {}

  /** What frees the native side when this object is gone; it must not refer to this object. */
  final void whenGone(Runnable free) {
    cleanable = CLEANER.register(this, free);
  }

  /** Frees the native side; for objects that no other code can be using. */
  final void freeNow() {
    cleanable.clean();
  }

  /** kept stays reachable as long as object is, and goes after it. */
  static void keepWith(Object object, Object kept) {
    CLEANER.register(object, () -> Reference.reachabilityFence(kept));
  }

  /** Frees what was made for one call. */
  static void free(NativeObject made) {
    if (made != null) {
      made.freeNow();
    }
  }

  static NativeCloudList listOf(List<Cloud> clouds) {
    if (clouds == null) {
      return null;
    }
    final NativeCloudList list = new NativeCloudList();
    clouds.forEach(list::add);
    return list;
  }

  @Override
  public abstract void close();
}
