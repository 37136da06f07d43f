# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

find_package(Java 11 COMPONENTS Development)
find_package(JNI)
if(NOT Java_FOUND OR NOT JNI_FOUND)
  message(STATUS "Bindings: no Java, a development kit of 11 or later is missing")
  return()
endif()
set(java_swig "${CMAKE_CURRENT_BINARY_DIR}/java_swig/org/jalon")
set(java_params "${CMAKE_CURRENT_BINARY_DIR}/java_params/org/jalon")
set(java_folder "${CMAKE_CURRENT_BINARY_DIR}/java")
set(java_written "${CMAKE_CURRENT_SOURCE_DIR}/java/src/main/java/org/jalon")

# Comments, overloads, results and setters that only Java has.
file(GLOB java_generator CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/java/*.py")
add_custom_command(
  OUTPUT "${generated}/java_api.i"
  COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/java/generate.py" "${generated}/java_api.i" "${java_params}" "${params_json}"
  COMMAND "${CMAKE_COMMAND}" -E touch "${generated}/java_api.i"
  DEPENDS "${params_json}" ${java_generator} ${generator} ${public_headers} VERBATIM)
set(common_files ${generated_files})
list(APPEND generated_files "${generated}/java_api.i")
jalon_wrapper(jalon_java java "${java_swig}" -package org.jalon)
set(generated_files ${common_files})
target_include_directories(jalon_java PRIVATE ${JNI_INCLUDE_DIRS})

# native/OS-ARCHITECTURE as NativeLibrary.platform() names it: the wrapper finds libjalon beside itself, in the jar as here.
string(TOLOWER "${CMAKE_SYSTEM_NAME}" java_os)
string(REPLACE "darwin" "macos" java_os "${java_os}")
string(TOLOWER "${CMAKE_SYSTEM_PROCESSOR}" java_arch)
string(REGEX REPLACE "^(amd64|x64)$" "x86_64" java_arch "${java_arch}")
string(REGEX REPLACE "^arm64$" "aarch64" java_arch "${java_arch}")
set(java_native "${java_folder}/resources/native/${java_os}-${java_arch}")
set_target_properties(jalon_java PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${java_native}" BUILD_WITH_INSTALL_RPATH ON)
jalon_natives(java_natives "${java_native}" "${java_native}/files.txt")

# The jar, its sources beside each other for Maven (pom.xml takes them from there), by javac alone: SWIG decides how many there are.
file(GLOB java_sources CONFIGURE_DEPENDS "${java_written}/*.java")
set(java_merged "${java_folder}/sources/org/jalon")
add_custom_command(
  OUTPUT "${java_folder}/jalon.jar"
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${java_folder}/classes" "${java_folder}/sources"
  COMMAND "${CMAKE_COMMAND}" -E copy_directory "${java_written}" "${java_merged}"
  COMMAND "${CMAKE_COMMAND}" -E copy_directory "${java_swig}" "${java_merged}"
  COMMAND "${CMAKE_COMMAND}" -E copy_directory "${java_params}" "${java_merged}"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${java_folder}/resources/META-INF"
  COMMAND "${CMAKE_COMMAND}" -E copy "${third_party}" "${PROJECT_SOURCE_DIR}/LICENSE" "${java_folder}/resources/META-INF"
  COMMAND sh -c "'${Java_JAVAC_EXECUTABLE}' --release 11 -parameters -Xlint:all -Werror -encoding UTF-8 -d '${java_folder}/classes' '${java_merged}'/*.java"
  COMMAND "${Java_JAR_EXECUTABLE}" cf "${java_folder}/jalon.jar" -C "${java_folder}/classes" . -C "${java_folder}/resources" .
  DEPENDS jalon_java "${natives_stamp}" ${java_sources} "${generated}/java_api.i" VERBATIM)
add_custom_target(jalon_jar DEPENDS "${java_folder}/jalon.jar")
add_dependencies(bindings jalon_jar)
