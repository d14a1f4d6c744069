# SPDX-License-Identifier: GPL-3.0-or-later
# Compiler settings that hold for every target.
option(MOTORBENCH_TESTS "Build the tests" ON)
option(MOTORBENCH_BENCHMARKS "Build the benchmarks" OFF)
set(MOTORBENCH_SANITIZE "" CACHE STRING "Sanitizers to build with, for example address,undefined or thread")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE RelWithDebInfo)
endif()

# One cache serves every checkout: paths below the source folder are hashed and recorded relative to it. The settings go with
# the command, so that nobody has to configure ccache.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime "${CCACHE_PROGRAM}")
endif()
add_compile_options("-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.")

add_library(motorbench_warnings INTERFACE)
target_compile_options(motorbench_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
  -Woverloaded-virtual -Wcast-align -Wformat=2 -Wimplicit-fallthrough -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(motorbench_warnings INTERFACE -Wduplicated-cond -Wlogical-op -Wno-free-nonheap-object)
endif()

if(MOTORBENCH_SANITIZE)
  target_compile_options(motorbench_warnings INTERFACE -Wno-error) # GCC warns of code that its sanitizers insert
  add_compile_options(-fsanitize=${MOTORBENCH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_compile_definitions(_GLIBCXX_ASSERTIONS) # one past the end of a vector is seen inside its capacity too
  add_link_options(-fsanitize=${MOTORBENCH_SANITIZE})
endif()
