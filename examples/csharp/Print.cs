// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Globalization;
using Jalon;

/// <summary>What the examples share: numbers as C prints them, and one line for what goes wrong.</summary>
static class Print {
  /// <summary>As "%.2f" of C, in any culture, with the sign of what rounds to zero.</summary>
  public static string Fixed(double value, int digits) {
    bool negative = value < 0 || (value == 0 && double.IsNegativeInfinity(1 / value));
    return (negative ? "-" : "") + Math.Abs(value).ToString("F" + digits, CultureInfo.InvariantCulture);
  }

  /// <summary>Runs the example; the exit status of the program.</summary>
  public static int Guard(Action example) {
    try {
      example();
      return 0;
    } catch (JalonException error) {
      Console.Error.WriteLine(Library.StatusName((int)error.Status) + ": " + error.Message);
      return 1;
    }
  }
}
