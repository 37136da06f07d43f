// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

/// <summary>An object that holds parameters and no data; its properties are the parameters of its methods.</summary>
public abstract class Worker : Noun {
  private Params parameters;

  internal Worker(Box box) : base(box) {}

  /// <summary>The worker's own parameters: setting one changes the worker. It lives as long as the worker.</summary>
  public Params Parameters {
    get {
      Live();
      return parameters ?? (parameters = MakeParams());
    }
  }

  internal abstract Params MakeParams();

  internal override void DisposeOwned() {
    if (parameters != null) parameters.Dispose();
  }
}

}
