# SPDX-License-Identifier: GPL-3.0-or-later
# Every dependency is a Debian package and says what it is for.
include(FeatureSummary)
add_feature_info(ccache CCACHE_PROGRAM "what was compiled once is not compiled again")
find_package(Threads REQUIRED)
set_package_properties(Threads PROPERTIES TYPE REQUIRED PURPOSE "The engine thread and its mailbox")

find_package(PkgConfig REQUIRED)
set_package_properties(PkgConfig PROPERTIES TYPE REQUIRED PURPOSE "Finds what has no CMake files of its own")
pkg_check_modules(GPIOD REQUIRED IMPORTED_TARGET libgpiod<2)
add_feature_info(libgpiod GPIOD_FOUND "1.6: ready and reset line of SPI boards")
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
add_feature_info(libzstd ZSTD_FOUND "chunks of recordings that other programs made")
pkg_check_modules(LZ4 REQUIRED IMPORTED_TARGET liblz4)
add_feature_info(liblz4 LZ4_FOUND "the same, packed the other way")
pkg_check_modules(MOSQUITTO REQUIRED IMPORTED_TARGET libmosquitto)
add_feature_info(libmosquitto MOSQUITTO_FOUND "`watch --to mqtt://`: samples to a broker")

find_package(Qt5 5.15 REQUIRED COMPONENTS Core Gui Widgets PrintSupport Svg Sql SerialPort SerialBus DBus LinguistTools)
set_package_properties(Qt5 PROPERTIES TYPE REQUIRED
  PURPOSE "Core: JSON, descriptors in an event loop. Widgets, Svg: the window. Sql: the notebook (driver QSQLITE), a journal that stations share (driver QPSQL, package libqt5sql5-psql, asked for when it is wanted). SerialPort, SerialBus: links. LinguistTools: translations")
find_package(QCustomPlot REQUIRED) # needs Qt5 PrintSupport found before it
set_package_properties(QCustomPlot PROPERTIES TYPE REQUIRED PURPOSE "Axes, layers and export of the plots")
find_package(tl-expected CONFIG REQUIRED)
set_package_properties(tl-expected PROPERTIES TYPE REQUIRED PURPOSE "Result<T>: value or fault, without exceptions")
find_package(CLI11 CONFIG REQUIRED)
set_package_properties(CLI11 PROPERTIES TYPE REQUIRED PURPOSE "Arguments of motorbenchctl")
find_package(muparser CONFIG REQUIRED)
set_package_properties(muparser PROPERTIES TYPE REQUIRED PURPOSE "Formulas of derived signals in plots")
find_library(FFTW3_LIBRARY fftw3 REQUIRED)
add_feature_info(fftw3 FFTW3_LIBRARY "the spectrum of a selection, of any length")

if(MOTORBENCH_TESTS)
  find_package(Qt5 5.15 REQUIRED COMPONENTS Test)
  # QFINDTESTDATA's folder of this build, which no test asks for: it would keep a compiler cache from serving another checkout.
  set_property(TARGET Qt5::Test PROPERTY INTERFACE_COMPILE_DEFINITIONS QT_TESTLIB_LIB)
  find_package(GTest REQUIRED)
  set_package_properties(GTest PROPERTIES TYPE REQUIRED PURPOSE "Tests of the device library")
endif()
if(MOTORBENCH_BENCHMARKS)
  find_package(benchmark REQUIRED)
  set_package_properties(benchmark PROPERTIES TYPE REQUIRED PURPOSE "Measurements printed by scripts/benchmark")
endif()
