# SPDX-License-Identifier: GPL-3.0-or-later
# Most of the time of a fresh build is parsing headers. MOTORBENCH_UNITS (the presets that build from nothing set it) parses
# them once for each group of targets and compiles the files of a target in units of several. The presets for everyday work and
# for the second compiler do neither: there a changed file is compiled alone, and a missing #include is found.
option(MOTORBENCH_UNITS "Compile several files as one unit, with precompiled headers: for builds from nothing" OFF)

if(MOTORBENCH_UNITS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # The first tells of coroutines whose locals have types of their own file, which in a unit is not the main file. The others
  # are false for std::string in GCC 12 once more of it is inlined. The everyday build, which scripts/test --full makes too, has all.
  target_compile_options(motorbench_warnings INTERFACE -Wno-subobject-linkage -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
endif()
if(MOTORBENCH_UNITS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # A sixth of the time was spent on collecting memory that a compiler which ends soon need not collect: 1.1 GB instead of 1.0.
  add_compile_options("SHELL:--param ggc-min-heapsize=2000000" "SHELL:--param ggc-min-expand=200")
endif()
if(MOTORBENCH_UNITS AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # In a unit it also tells of a local that hides what another file has for itself alone. The preset clang, without units, has it.
  target_compile_options(motorbench_warnings INTERFACE -Wno-shadow)
endif()

# header_group(NAME LIBRARIES ... [HEADERS ...] [STRICT]): headers that every target of compile_fast(... NAME) has parsed already.
function(header_group name)
  cmake_parse_arguments(_group STRICT "" "LIBRARIES;HEADERS" ${ARGN})
  if(NOT MOTORBENCH_UNITS)
    return()
  endif()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "// Carries precompiled headers.\n")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  set_target_properties(${name} PROPERTIES AUTOMOC OFF AUTORCC OFF)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/devices)
  target_link_libraries(${name} PRIVATE ${_group_LIBRARIES} motorbench_warnings)
  target_precompile_headers(${name} PRIVATE ${_group_HEADERS})
  if(_group_STRICT)
    strict_qt(${name})
  endif()
endfunction()

# compile_fast(TARGET GROUP [FILES_A_UNIT]): nothing in the everyday build.
function(compile_fast target group)
  if(NOT MOTORBENCH_UNITS)
    return()
  endif()
  if(TARGET ${group})
    target_precompile_headers(${target} REUSE_FROM ${group})
  endif()
  if(ARGC GREATER 2)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${ARGV2})
  endif()
endfunction()

# Qt's short keywords (signals, emit, foreach) are names like any other to what does not ask for Qt.
set(MOTORBENCH_PLAIN_QT QT_NO_KEYWORDS QT_NO_FOREACH)
set(_standard <algorithm> <array> <chrono> <cmath> <cstdint> <deque> <functional> <map> <memory> <optional> <set> <span> <string>
    <string_view> <utility> <variant> <vector> <tl/expected.hpp>)
header_group(headers_standard LIBRARIES tl::expected HEADERS ${_standard})
set(_core <QCoreApplication> <QDir> <QFile> <QFileInfo> <QJsonDocument> <QJsonObject> <QSocketNotifier> <QString>)
header_group(headers_devices STRICT LIBRARIES tl::expected Qt5::Core HEADERS ${_standard} ${_core})
header_group(headers_console STRICT LIBRARIES tl::expected Qt5::Core CLI11::CLI11 HEADERS ${_standard} ${_core} <CLI/CLI.hpp>)
header_group(headers_window STRICT LIBRARIES tl::expected Qt5::Widgets HEADERS ${_standard} ${_core} <QtWidgets> ${PROJECT_SOURCE_DIR}/widgets/plots/qcustomplotkeywords.h)
if(MOTORBENCH_TESTS)
  header_group(headers_tests LIBRARIES tl::expected Qt5::Core GTest::gtest HEADERS ${_standard} ${_core} <gtest/gtest.h>)
  if(MOTORBENCH_UNITS)
    target_compile_definitions(headers_tests PRIVATE ${MOTORBENCH_PLAIN_QT})
  endif()
endif()
