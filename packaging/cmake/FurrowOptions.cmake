option(FURROW_TESTS "Build the tests and benchmarks" ON)
option(FURROW_WARNINGS_ARE_ERRORS "Stop at a compiler warning; off for packagers with other compilers" OFF)
set(FURROW_SANITIZE "" CACHE STRING "Sanitisers for every target: address,undefined or thread")

# Of a source that stands alone, its headers and their templates take more than half of the time.
option(FURROW_UNITE_SOURCES "Compile sources of one room together: less time from nothing, more after a change" ON)

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
# furrow_precompile_headers(TARGET REUSE_FROM OTHER) takes those of another target: its definitions are among TARGET's.
function(furrow_precompile_headers target)
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        if("${ARGV1}" STREQUAL REUSE_FROM)
            target_precompile_headers(${target} ${ARGN})
        else()
            target_precompile_headers(${target} PRIVATE ${ARGN})
        endif()
        target_compile_options(${target} PRIVATE -fpch-preprocess  # for ccache
            -Wno-array-bounds)  # GCC 14 warns of precompiled strings, wrongly
    endif()
endfunction()

# Adds sources to a target so that those of one folder are compiled together, a few at a time: headers and templates
# are then read once. Names in anonymous namespaces must differ within a folder. This is CMake's UNITY_BUILD, but with
# paths that are the same in every clone, for ccache, and with options of their own for the sources. What compiles each
# source alone is a target that nothing needs, TARGET_alone: with it compile_commands.json names each of them, for
# clang-tidy and editors, and building it finds missing includes. Call this when all libraries are linked.
function(furrow_add_united_sources target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;COMPILE_OPTIONS")
    set(compiled ${arg_SOURCES})
    if(FURROW_UNITE_SOURCES)
        set(most 8)
        set(compiled "")
        set(rooms "")
        foreach(source IN LISTS arg_SOURCES)
            cmake_path(ABSOLUTE_PATH source)
            cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
            cmake_path(GET source PARENT_PATH room)
            string(MAKE_C_IDENTIFIER ${room} room)
            list(APPEND rooms ${room})
            list(APPEND sources_${room} ${source})
        endforeach()
        list(REMOVE_DUPLICATES rooms)
        foreach(room IN LISTS rooms)
            list(LENGTH sources_${room} count)
            math(EXPR batches "(${count} + ${most} - 1) / ${most}")
            foreach(batch RANGE 1 ${batches})
                math(EXPR first "${count} * (${batch} - 1) / ${batches}")
                math(EXPR size "${count} * ${batch} / ${batches} - ${first}")
                list(SUBLIST sources_${room} ${first} ${size} sources)
                list(TRANSFORM sources REPLACE "(.+)" "#include \"\\1\"\n")
                list(JOIN sources "" text)
                set(file ${CMAKE_CURRENT_BINARY_DIR}/united/${room}_${batch}.cpp)
                file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)
                list(APPEND compiled ${file})
            endforeach()
        endforeach()
        add_library(${target}_alone OBJECT EXCLUDE_FROM_ALL ${arg_SOURCES})
        set_target_properties(${target}_alone PROPERTIES AUTOMOC OFF)
        target_compile_options(${target}_alone PRIVATE ${arg_COMPILE_OPTIONS})
        foreach(property IN ITEMS INCLUDE_DIRECTORIES COMPILE_DEFINITIONS LINK_LIBRARIES)
            get_target_property(value ${target} ${property})
            if(value)
                set_target_properties(${target}_alone PROPERTIES ${property} "${value}")
            endif()
        endforeach()
        if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
            # It takes all but the first file for headers, where types of anonymous namespaces would be a mistake.
            list(APPEND arg_COMPILE_OPTIONS -Wno-subobject-linkage)
        endif()
    endif()
    target_sources(${target} PRIVATE ${compiled})
    set_source_files_properties(${compiled} PROPERTIES
        COMPILE_OPTIONS "${arg_COMPILE_OPTIONS}" SKIP_UNITY_BUILD_INCLUSION ON)
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
