// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Jalon;

/// <summary>Real objects: what a member is called of, and what it takes.</summary>
static class Objects {
  /// <summary>What a member is called of; what it changes or disposes of is its own.</summary>
  public static object Subject(Type type, string member) {
    if (type == typeof(Cloud)) return CloudFor(member);
    if (type == typeof(CloudBuilder)) return Builder(member);
    if (type == typeof(Comparer)) {
      return new Comparer(new[] {"ReadM3c2File", "RunCore", "UseRegistration"}.Contains(member) ? "m3c2" : "distance");
    }
    if (type == typeof(Registrar)) return new Registrar(member == "RunTargets" ? "targets" : "icp");
    if (type == typeof(Model) && member == "RemoveCopy") return Survey.Repeated;
    if (type == typeof(Model) && member == "PerturbStrips") return Survey.Scene.BuildingStrips().Model;
    if (type == typeof(Trajectory) && member == "Adjust") return Survey.Driven.Trajectory;
    if (type == typeof(Scanner) && member == "Drive") return new Scanner("mobile") { Pulses = 50 };
    if (type == typeof(Segmentation) && member == "Pick") return Segmentation.Start(Survey.Scan);
    return Of(type, type.Name + "." + member, "self");
  }

  static Cloud CloudFor(string member) {
    bool round = member == "FitSphere" || member == "FitCircle" || member == "MeasureTargets";
    Cloud cloud = Survey.CopyOf(round ? Survey.Sphere : member == "FitCylinder" ? Survey.Pipe : Survey.Scan);
    if (member == "InvertNormals") cloud.ComputeNormals();
    return cloud;
  }

  static CloudBuilder Builder(string member) {
    var builder = new CloudBuilder();
    if (member == "AppendField" || member == "Seal") {
      builder.DeclareField("mine", (int)ElementType.Float64);
      builder.AppendPoints(new double[12]);
    }
    if (member == "Seal") builder.AppendField("mine", new double[4]);
    return builder;
  }

  /// <summary>A builder for flags.</summary>
  public static CloudBuilder FlagBuilder() {
    var builder = new CloudBuilder();
    builder.DeclareField("mine", (int)ElementType.Uint8);
    builder.AppendPoints(new double[12]);
    return builder;
  }

  /// <summary>A real object of this class.</summary>
  public static object Of(Type type, string where, string name) {
    string member = where.Substring(where.IndexOf('.') + 1);
    bool isDriven = where == "Trajectory.Adjust" || where == "Adjustment.Apply";
    if (isDriven && type == typeof(Cloud)) return Survey.Driven.Cloud;
    if (isDriven && type == typeof(Model)) return Survey.Driven.Model;
    if (type == typeof(Adjustment)) return Survey.Adjusted;
    if (type == typeof(Network)) return Network.Adjust(Survey.Sights, Survey.Nails);
    if (type == typeof(Sections)) return Survey.Scan.Sections();
    if (type == typeof(Cloud)) return name == "compared" || name == "moving" || name == "b" ? Survey.Second : Survey.Scan;
    if (type == typeof(Model)) return member == "GaugeSweepModel" && name == "gauge" ? Survey.Tetrahedron() : Survey.Facade;
    if (type == typeof(Params)) return name == "self" ? new NormalsOptions() : null;
    if (type == typeof(Comparison)) return name == "reverse" ? Survey.Reverse : Survey.Forward;
    if (type == typeof(Fields)) {
      return name == "places" ? Survey.Swept.Places : name == "intervals" ? Survey.Swept.Intervals
          : name == "changes" ? Survey.Diagnosis.Changes : name == "forwardPoints" ? Survey.Diagnosis.Forward
          : name == "reversePoints" ? Survey.Diagnosis.Reverse : Survey.Scan.GetFields();
    }
    if (type == typeof(Segmentation)) return Survey.Planes;
    if (type == typeof(Registration)) return Survey.Registered;
    if (type == typeof(NoiseLaw)) return Survey.Law;
    if (type == typeof(Trajectory)) return Survey.Drive();
    if (type == typeof(Evaluation)) return Survey.Planes.Evaluate(Survey.Planes);
    if (type == typeof(ModelEvaluation)) return Survey.Facade.Evaluate(Survey.Scene);
    if (type == typeof(Gauge)) return Survey.Gauge();
    if (type == typeof(Targets)) return Survey.Targets();
    if (type == typeof(ArrayView)) return Survey.Scan.GetPoints();
    if (type == typeof(IEnumerable<Cloud>)) return new[] {Survey.CopyOf(Survey.Scan), Survey.CopyOf(Survey.Second)};
    if (type == typeof(Segmenter) || type == typeof(Modeller) || type == typeof(Scanner)) return Activator.CreateInstance(type, Optional(type));
    if (type == typeof(JalonTask)) return name == "self" ? new JalonTask(1) : null;
    if (type == typeof(Progress)) return (Progress)((fraction, stage) => true);
    if (type == typeof(Log)) return (Log)((level, text) => {});
    if (type == typeof(CancellationToken)) return CancellationToken.None;
    return type == typeof(Array) ? new double[6] : null;
  }

  static object[] Optional(Type worker) {
    return new object[] {((string[])worker.GetMethod("Methods").Invoke(null, null))[0]};
  }
}
