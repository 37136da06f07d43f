// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;

namespace Jalon {

public sealed partial class Fields {
  /// <summary>The names of the columns.</summary>
  public string[] Names {
    get {
      var names = new string[Count];
      for (int i = 0; i < names.Length; ++i) names[i] = Info(i).Name;
      return names;
    }
  }

  /// <summary>A view of the column of that name, without a copy.</summary>
  public ArrayView this[string name] {
    get { return View(name); }
  }

  /// <summary>The column as doubles, item by item, whatever its type.</summary>
  public double[] Doubles(string name) {
    using (ArrayView view = View(name)) return view.ToDoubles();
  }

  /// <summary>
  /// Copies of all columns by name, each an array of its own type, with rows (double[,]) where it has several components.
  /// </summary>
  public Dictionary<string, Array> ToDictionary() {
    var columns = new Dictionary<string, Array>();
    foreach (string name in Names) {
      using (ArrayView view = View(name)) columns[name] = view.Components == 1 ? view.ToArray() : view.ToRows();
    }
    return columns;
  }
}

}
