// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/**
 * A call of Jalon failed; the message is one helpful line. All failures are unchecked and of this class; a subclass stands
 * for each status that a program may want to catch alone:
 *
 * <p>{@link InvalidArgumentException}, {@link NotFoundException}, {@link InsufficientDataException},
 * {@link DegenerateException}, {@link CancelledException}, {@link FileException}, {@link FormatException},
 * {@link UnsupportedException}, {@link LimitException}, {@link BusyException}, {@link ClosedException}. Too little memory
 * on the native side and errors of the library itself are plain JalonExceptions.
 */
public class JalonException extends RuntimeException {
  private static final long serialVersionUID = 1L;
  private final int status;

  JalonException(int status, String message) {
    super(message);
    this.status = status;
  }

  /** The status of the C library, one of the ERROR_ constants of {@link JalonConstants}. */
  public int status() {
    return status;
  }

  /** Called by the native code for every failure. */
  static JalonException of(int status, byte[] utf8) {
    final String message = Text.of(utf8);
    switch (status) {
      case -1: return new InvalidArgumentException(status, message);
      case -3: return new CancelledException(status, message);
      case -4: return new NotFoundException(status, message);
      case -5: return new InsufficientDataException(status, message);
      case -6: return new DegenerateException(status, message);
      case -7: return new FileException(status, message);
      case -8: return new FormatException(status, message);
      case -9: return new UnsupportedException(status, message);
      case -11: return new BusyException(status, message);
      case -12: return new LimitException(status, message);
      case -1000: return new ClosedException(-1, message); // C has no closed handles: an invalid argument there
      default: return new JalonException(status, message);
    }
  }
}
