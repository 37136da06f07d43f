# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

# viewer.js as text of the room report: both files joined, without comments and indents, and the hash of that text.
set(viewer "${CMAKE_CURRENT_SOURCE_DIR}/report/viewer")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${viewer}/viewer.js" "${viewer}/viewer_hand.js")
file(READ "${viewer}/viewer.js" script)
file(READ "${viewer}/viewer_hand.js" hand)
string(REPLACE "//@include viewer_hand.js" "${hand}" script "${script}")
string(REGEX REPLACE "(^|\n)[ ]*//[^\n]*" "" script "${script}")
string(REGEX REPLACE "\n[ \n]+" "\n" script "${script}")
string(STRIP "${script}" script)
string(SHA256 hash "${script}")
file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/viewer_script.cpp" CONTENT
"#include \"report/viewer/script.h\"
namespace jalon {
const char kViewerScript[] = R\"script(${script})script\";
const char kViewerScriptSha256[] = \"${hash}\";
}
")
target_sources(jalon_report PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/viewer_script.cpp")
set_source_files_properties("${CMAKE_CURRENT_BINARY_DIR}/viewer_script.cpp" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
