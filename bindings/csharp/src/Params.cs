// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;

namespace Jalon {

public partial class Params {
  private Dictionary<string, ParamType> types;

  /// <summary>The names of the parameters, in the order of the table.</summary>
  public string[] Names {
    get {
      var names = new string[Count];
      for (int i = 0; i < names.Length; ++i) names[i] = Info(i).Name;
      return names;
    }
  }

  /// <summary>Sets one value by its name; whole numbers also where a double is wanted.</summary>
  /// <exception cref="NotFoundException">There is no parameter of that name; the message lists those there are.</exception>
  /// <exception cref="InvalidArgumentException">The value is of a wrong type or out of range.</exception>
  public void Set(string name, double value) {
    SetDouble(name, value);
  }

  /// <summary>Sets one value by its name.</summary>
  public void Set(string name, long value) {
    if (TypeOf(name) == ParamType.Double) SetDouble(name, value);
    else SetInt64(name, value);
  }

  /// <summary>Sets one value by its name.</summary>
  public void Set(string name, bool value) {
    SetBool(name, value);
  }

  /// <summary>Sets one value by its name, also a choice.</summary>
  public void Set(string name, string value) {
    SetString(name, value);
  }

  /// <summary>Sets one value by its name.</summary>
  public void Set(string name, double[] value) {
    SetDoubles(name, value);
  }

  /// <summary>One value as double, long, bool, string or double[].</summary>
  public object Get(string name) {
    switch (TypeOf(name)) {
      case ParamType.Double: return GetDouble(name);
      case ParamType.Int64: return GetInt64(name);
      case ParamType.Bool: return GetBool(name);
      case ParamType.Doubles: return GetDoubles(name);
      default: return GetString(name);  // of an unknown name: says which there are
    }
  }

  private ParamType TypeOf(string name) {
    if (types == null) {
      var found = new Dictionary<string, ParamType>();
      for (long i = 0; i < Count; ++i) {
        ParamsInfoResult row = Info(i);
        found[row.Name] = (ParamType)row.Type;
      }
      types = found;
    }
    ParamType type;
    return name != null && types.TryGetValue(name, out type) ? type : 0;
  }
}

}
