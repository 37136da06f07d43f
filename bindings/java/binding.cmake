# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

find_package(Java 11 COMPONENTS Development)
find_package(JNI)
if(NOT Java_FOUND OR NOT JNI_FOUND)
  message(STATUS "Bindings: no Java, a development kit of 11 or later is missing")
  return()
endif()
set(java_generated "${CMAKE_CURRENT_BINARY_DIR}/java_swig/org/jalon")
set(java_folder "${CMAKE_CURRENT_BINARY_DIR}/java")
jalon_wrapper(jalon_java java "${java_generated}" -package org.jalon)
target_include_directories(jalon_java PRIVATE ${JNI_INCLUDE_DIRS})
set_target_properties(jalon_java PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${java_folder}")
# The jar is made by hand: SWIG decides how many classes there are.
file(GLOB java_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/java/src/main/java/org/jalon/*.java")
add_custom_command(
  OUTPUT "${java_folder}/jalon.jar"
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${java_folder}/classes"
  COMMAND sh -c "'${Java_JAVAC_EXECUTABLE}' --release 11 -Xlint:-removal -nowarn -d '${java_folder}/classes' '${java_generated}'/*.java '${CMAKE_CURRENT_SOURCE_DIR}'/java/src/main/java/org/jalon/*.java"
  COMMAND "${Java_JAR_EXECUTABLE}" cf "${java_folder}/jalon.jar" -C "${java_folder}/classes" .
  DEPENDS jalon_java ${java_sources} VERBATIM)
add_custom_target(jalon_jar DEPENDS "${java_folder}/jalon.jar")
add_dependencies(bindings jalon_jar)
