option(FURROW_TESTS "Build the tests and benchmarks" ON)
option(FURROW_WARNINGS_ARE_ERRORS "Stop at a compiler warning; off for packagers with other compilers" OFF)
set(FURROW_SANITIZE "" CACHE STRING "Sanitisers for every target: address,undefined or thread")

option(FURROW_FUZZ "Build the fuzz targets of tests/fuzz instead of the tests; needs clang" OFF)

set(CMAKE_CXX_STANDARD 23)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_SCAN_FOR_MODULES OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

find_program(FURROW_CCACHE ccache)
if(FURROW_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${FURROW_CCACHE})
endif()

if(FURROW_SANITIZE)
    add_compile_options(-fsanitize=${FURROW_SANITIZE} -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${FURROW_SANITIZE})
endif()

if(FURROW_FUZZ)
    # Every file counts its branches for libFuzzer and looks for bad addresses and undefined behaviour.
    add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
endif()

# Warnings for our own code; generated code of Qt's tools goes without.
add_library(furrow_warnings INTERFACE)
target_compile_options(furrow_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow=local -Wconversion -Wno-sign-conversion -Wold-style-cast
    # Members that are left out of an initialiser have defaults; that is what designated ones are for.
    -Wno-missing-field-initializers
    $<$<BOOL:${FURROW_WARNINGS_ARE_ERRORS}>:-Werror>)

# Headers that nearly every source of a target includes: a fifth to a third of the time of compiling one. Sources name
# them all the same. Not with clang, whose precompiled headers ccache does not know.
function(furrow_precompile_headers target)
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        target_precompile_headers(${target} PRIVATE ${ARGN})
        target_compile_options(${target} PRIVATE -fpch-preprocess  # for ccache
            -Wno-array-bounds)  # GCC 14 warns of precompiled strings, wrongly
    endif()
endfunction()

# moc runs again where a source has changed, but not where one was added.
function(furrow_look_at_new_sources program)
    get_target_property(sources ${program} SOURCES)
    set(list ${CMAKE_CURRENT_BINARY_DIR}/${program}_sources.txt)
    set(known "")
    if(EXISTS ${list})
        file(READ ${list} known)
    endif()
    if(NOT known STREQUAL "${sources}")
        file(REMOVE ${CMAKE_CURRENT_BINARY_DIR}/${program}_autogen/timestamp)
        file(WRITE ${list} "${sources}")
    endif()
endfunction()
