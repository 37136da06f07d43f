// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** Hears how far a call has come, on the thread that made the call, about every 50-100 ms. */
@FunctionalInterface
public interface ProgressListener {
  /**
   * Returns whether to go on; false ends the call with {@link CancelledException}, an exception ends it as that exception.
   * It must not call Jalon with the same task, but for {@link Task#cancel()}.
   *
   * @param fraction grows from 0 to 1, which it reaches on success only
   * @param stage a short English phrase
   */
  boolean onProgress(double fraction, String stage);
}
