/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file export.h
 * Linkage and compiler macros of the public headers; nothing to call.
 */
#ifndef JALON_EXPORT_H
#define JALON_EXPORT_H

#include <stdint.h>

#ifdef __cplusplus
#define JALON_BEGIN_C extern "C" {
#define JALON_END_C }
#else
#define JALON_BEGIN_C
#define JALON_END_C
#endif

#if defined(_WIN32) && defined(JALON_STATIC)
#define JALON_API
#elif defined(_WIN32)
#if defined(JALON_BUILDING)
#define JALON_API __declspec(dllexport)
#else
#define JALON_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define JALON_API __attribute__((visibility("default")))
#else
#define JALON_API
#endif

/* Ignored return codes become damage later: the compiler says so. */
#if defined(__GNUC__)
#define JALON_CHECK __attribute__((warn_unused_result))
#else
#define JALON_CHECK
#endif

#endif
