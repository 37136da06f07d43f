// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

/// <summary>Small results as arrays of their own: points, boxes, transforms, covariances.</summary>
internal static class Small {
  internal static double[] Row(IntPtr array) {
    using (ArrayView view = ArrayView.Wrap(array)) return view == null ? null : view.ToDoubles();
  }

  internal static byte[] Octets(IntPtr array) {
    using (ArrayView view = ArrayView.Wrap(array)) return view == null ? null : view.ToArray<byte>();
  }

  internal static double[,] Rows(IntPtr array) {
    using (ArrayView view = ArrayView.Wrap(array)) return view == null ? null : (double[,])view.ToRows();
  }
}

}
