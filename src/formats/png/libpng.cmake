# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

# libpng for all PNG: formats/png/libpng_*.cpp, and no other file, are built with it; without it libpng_absent.cpp stands
# in.
get_target_property(sources jalon_formats SOURCES)
if(JALON_WITH_LIBPNG)
  list(FILTER sources EXCLUDE REGEX "libpng_absent\\.cpp$")
  target_link_libraries(jalon_formats PRIVATE PNG::PNG)
else()
  list(FILTER sources EXCLUDE REGEX "libpng_(file|writing)\\.cpp$")
endif()
set_target_properties(jalon_formats PROPERTIES SOURCES "${sources}")
