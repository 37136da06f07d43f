# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0

# LAZ and E57 for the room formats: the static library of rust/, which cargo builds from what Cargo.lock names. The crates
# are fetched when the build is configured and lie in cargo's own folder from then on; a folder of them made by "cargo
# vendor" is taken where JALON_CRATES names it, without any network. Without the component absent.cpp stands in.
set(JALON_CRATES "" CACHE PATH "A folder made by cargo vendor, for a build without network")
set(jalon_has_codecs OFF)

# Sets jalon_has_codecs where cargo is there and has the crates.
function(jalon_look_for_codecs)
  set(jalon_codecs_missing "" PARENT_SCOPE)
  if(CMAKE_CROSSCOMPILING OR WIN32 OR JALON_STATIC)
    set(jalon_codecs_missing "they are built for a shared library of this machine's system alone" PARENT_SCOPE)
    return()
  endif()
  find_program(JALON_CARGO NAMES cargo)
  if(NOT JALON_CARGO)
    set(jalon_codecs_missing "there is no cargo (Debian 12: apt install cargo-web)" PARENT_SCOPE)
    return()
  endif()
  # The newest of the language that the crates use: Debian 12's own cargo-web may be older, that of its security updates
  # is not.
  find_program(JALON_RUSTC NAMES rustc)
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/codecs_probe.rs"
       "pub fn probe(n: u64) -> u64 { std::hint::select_unpredictable(n.is_multiple_of(4), n, 0) }\n")
  execute_process(COMMAND "${JALON_RUSTC}" --crate-type lib --emit metadata -o "${CMAKE_CURRENT_BINARY_DIR}/codecs_probe"
                          "${CMAKE_CURRENT_BINARY_DIR}/codecs_probe.rs" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed)
    set(jalon_codecs_missing "rustc is too old (1.90 will do)" PARENT_SCOPE)
    return()
  endif()
  set(options --locked --manifest-path "${CMAKE_CURRENT_SOURCE_DIR}/formats/codecs/rust/Cargo.toml")
  if(JALON_CRATES)
    list(APPEND options --config "source.crates-io.replace-with=\"jalon-crates\""
         --config "source.jalon-crates.directory=\"${JALON_CRATES}\"")
  endif()
  # Without network where the crates are there already.
  execute_process(COMMAND "${JALON_CARGO}" fetch --offline ${options} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(failed AND NOT JALON_CRATES)
    execute_process(COMMAND "${JALON_CARGO}" fetch ${options} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET TIMEOUT 60)
  endif()
  if(failed)
    set(jalon_codecs_missing "cargo cannot get the crates" PARENT_SCOPE)
    return()
  endif()
  set(jalon_cargo_options "${options}" PARENT_SCOPE)
  set(jalon_has_codecs ON PARENT_SCOPE)
endfunction()

if(JALON_WITH_RUST_FORMATS)
  jalon_look_for_codecs()
  if(NOT jalon_has_codecs)
    set(mode STATUS)
    if(NOT JALON_WITH_RUST_FORMATS STREQUAL "AUTO")
      set(mode FATAL_ERROR)
    endif()
    message(${mode} "Without LAZ and E57: ${jalon_codecs_missing}")
  endif()
endif()

get_target_property(sources jalon_formats SOURCES)
if(jalon_has_codecs)
  # What a panic would say of its place names no folder of the machine that built it.
  set(cargo_home "$ENV{CARGO_HOME}")
  if(NOT cargo_home)
    set(cargo_home "$ENV{HOME}/.cargo")
  endif()
  # Parted by a character that no folder's name has: names with blanks are whole.
  string(ASCII 31 next)
  set(codecs_flags "CARGO_ENCODED_RUSTFLAGS=--remap-path-prefix=${cargo_home}=crates${next}--remap-path-prefix=${PROJECT_SOURCE_DIR}=jalon")
  set(codecs_folder "${CMAKE_CURRENT_BINARY_DIR}/codecs")
  set(codecs_library "${codecs_folder}/release/libjalon_codecs.a")
  set(codecs_fuzzing)
  if(JALON_FUZZ) # coverage for libFuzzer here too; a target that is named keeps the flags from programs that run while building
    execute_process(COMMAND "${JALON_RUSTC}" -vV OUTPUT_VARIABLE rustc_says)
    string(REGEX MATCH "host: ([^\n]+)" rustc_says "${rustc_says}")
    set(codecs_library "${codecs_folder}/${CMAKE_MATCH_1}/release/libjalon_codecs.a")
    set(codecs_fuzzing "CARGO_BUILD_TARGET=${CMAKE_MATCH_1}" CARGO_PROFILE_RELEASE_LTO=off)
    string(APPEND codecs_flags "${next}-Cpasses=sancov-module")
    foreach(part level=4 inline-8bit-counters pc-table trace-compares)
      string(APPEND codecs_flags "${next}-Cllvm-args=-sanitizer-coverage-${part}")
    endforeach()
  endif()
  file(GLOB codecs_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/formats/codecs/rust/src/*.rs"
       "${CMAKE_CURRENT_SOURCE_DIR}/formats/codecs/rust/Cargo.*")
  add_custom_command(OUTPUT "${codecs_library}" DEPENDS ${codecs_sources} VERBATIM COMMENT "Building LAZ and E57 by cargo"
                     COMMAND "${CMAKE_COMMAND}" -E env "CARGO_TARGET_DIR=${codecs_folder}" "${codecs_flags}" ${codecs_fuzzing}
                             "${JALON_CARGO}" build --quiet
                             --release --offline ${jalon_cargo_options})
  add_custom_target(jalon_codecs_library DEPENDS "${codecs_library}")
  add_dependencies(jalon_formats jalon_codecs_library)
  # What Rust's standard library asks of the system.
  target_link_libraries(jalon_formats PUBLIC "${codecs_library}" ${CMAKE_DL_LIBS} Threads::Threads m)
  list(FILTER sources EXCLUDE REGEX "codecs/absent\\.cpp$")
else()
  list(FILTER sources EXCLUDE REGEX "codecs/present\\.cpp$")
endif()
set_target_properties(jalon_formats PROPERTIES SOURCES "${sources}")
