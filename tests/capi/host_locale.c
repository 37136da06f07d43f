/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Every C test is a host that follows its user's locale, as CAD programs do: with LC_ALL=de_DE.UTF-8 the decimal point
 * is a comma. */
#include <locale.h>

__attribute__((constructor)) static void follow_the_user(void) { setlocale(LC_ALL, ""); }
