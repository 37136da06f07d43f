// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
package org.jalon;

/** There is no method, parameter, field or part of that name; the message lists those there are. */
public final class NotFoundException extends JalonException {
  private static final long serialVersionUID = 1L;

  NotFoundException(int status, String message) {
    super(status, message);
  }
}
