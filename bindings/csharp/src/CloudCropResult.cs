// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;

namespace Jalon {

/// <summary>What Cloud.Crop gives.</summary>
public sealed class CloudCropResult : IDisposable {
  /// <summary>Takes inside over; disposes of it when there is no outside.</summary>
  internal CloudCropResult(Cloud inside, Func<Cloud> outside) {
    Inside = inside;
    try {
      Outside = outside();
    } catch {
      inside.Dispose();
      throw;
    }
  }

  /// <summary>The points for which the mask is true.</summary>
  public Cloud Inside { get; private set; }

  /// <summary>The others.</summary>
  public Cloud Outside { get; private set; }

  /// <summary>For var (inside, outside) = ...</summary>
  public void Deconstruct(out Cloud inside, out Cloud outside) {
    inside = Inside;
    outside = Outside;
  }

  /// <summary>The values of all outputs.</summary>
  public override string ToString() {
    return Described.Result("CloudCropResult", "Inside", Inside, "Outside", Outside);
  }

  /// <summary>Disposes of all of them.</summary>
  public void Dispose() {
    Inside.Dispose();
    Outside.Dispose();
  }
}

}
