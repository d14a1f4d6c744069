# SPDX-License-Identifier: GPL-3.0-or-later
# family_registry(TARGET FAMILY...): the library TARGET with the families of these names, in this order, and mb::families(), which
# lists them (devices/model/registry.h). A program links exactly one: `devices` has all that come with it.
set(MOTORBENCH_REGISTRY ${CMAKE_CURRENT_LIST_DIR}/registry.cpp.in)
function(family_registry target)
  set(FAMILY_DECLARATIONS)
  set(FAMILY_ENTRIES)
  foreach(_family ${ARGN})
    string(APPEND FAMILY_DECLARATIONS "namespace mb::${_family} { extern const Family family; }\n")
    string(APPEND FAMILY_ENTRIES "    &${_family}::family,\n")
  endforeach()
  configure_file(${MOTORBENCH_REGISTRY} ${CMAKE_CURRENT_BINARY_DIR}/${target}_registry.cpp @ONLY)
  add_library(${target} STATIC ${CMAKE_CURRENT_BINARY_DIR}/${target}_registry.cpp)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/devices)
  target_link_libraries(${target} PUBLIC model ${ARGN} PRIVATE motorbench_warnings)
endfunction()
