/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file jalon.h
 * All of Jalon: laser-scan surveying for CAD and GIS tools.
 *
 * Data nouns (cloud, model), workers that hold parameters (segmenter, modeller, comparer, registrar,
 * scanner), and what workers produce (segmentation, model, comparison, registration, cloud): learn
 * one, know all. Handles are reference counted: jalon_X_create makes one owner, jalon_X_retain adds
 * one, jalon_X_release takes one away, in any order. Outputs are written only on success.
 *
 * In the host's process: nothing is printed, no signal handler, locale, environment or working folder is changed. Every
 * call computes to the nearest, with gradual underflow and without traps, callbacks included, and gives the thread back
 * the rounding and the mode that it came with: the same input has the same bits in every host.
 */
#ifndef JALON_JALON_H
#define JALON_JALON_H

#include <jalon/export.h>
#include <jalon/version.h>
#include <jalon/status.h>
#include <jalon/types.h>
#include <jalon/task.h>
#include <jalon/params.h>
#include <jalon/fields.h>
#include <jalon/cloud.h>
#include <jalon/search.h>
#include <jalon/sections.h>
#include <jalon/model.h>
#include <jalon/adjustment.h>
#include <jalon/buildings.h>
#include <jalon/trajectory.h>
#include <jalon/georeference.h>
#include <jalon/segmenter.h>
#include <jalon/primitives.h>
#include <jalon/evaluate.h>
#include <jalon/precision.h>
#include <jalon/modeller.h>
#include <jalon/comparer.h>
#include <jalon/visibility.h>
#include <jalon/changes.h>
#include <jalon/clearance.h>
#include <jalon/registrar.h>
#include <jalon/targets.h>
#include <jalon/network.h>
#include <jalon/field_tools.h>
#include <jalon/volumes.h>
#include <jalon/scanner.h>
#include <jalon/io.h>
#include <jalon/bytes.h>
#include <jalon/report.h>

#endif
