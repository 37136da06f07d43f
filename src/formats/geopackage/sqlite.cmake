# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

# SQLite for GeoPackage: formats/geopackage/sqlite_database.cpp, and no other file, is built with it; without it
# sqlite_absent.cpp stands in.
get_target_property(sources jalon_formats SOURCES)
if(JALON_WITH_SQLITE)
  list(FILTER sources EXCLUDE REGEX "sqlite_absent\\.cpp$")
  target_link_libraries(jalon_formats PRIVATE SQLite::SQLite3)
else()
  list(FILTER sources EXCLUDE REGEX "sqlite_database\\.cpp$")
endif()
set_target_properties(jalon_formats PROPERTIES SOURCES "${sources}")
