// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** Hears the log lines of a call, on the thread that made it. An exception ends the call as that exception. */
@FunctionalInterface
public interface LogListener {
  /**
   * One line.
   *
   * @param level LOG_DEBUG, LOG_INFO or LOG_WARNING of {@link JalonConstants}
   * @param text without a line feed
   */
  void onLine(int level, String text);
}
