# SPDX-License-Identifier: GPL-3.0-or-later
# The layers of docs/architecture.md, enforced at configure time: a target whose link closure reaches something
# that its layer may not know ends the configuration.

# forbid_links(TARGET LIBRARY...): fails when TARGET links one of LIBRARY, directly or through others.
function(forbid_links target)
  get_target_property(_todo ${target} LINK_LIBRARIES)
  if(NOT _todo)
    return()
  endif()
  set(_seen)
  while(_todo)
    list(POP_FRONT _todo _lib)
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" _lib "${_lib}")
    if(_lib IN_LIST _seen OR NOT TARGET ${_lib})
      continue()
    endif()
    list(APPEND _seen ${_lib})
    if(_lib IN_LIST ARGN)
      message(FATAL_ERROR "layers: ${target} must not depend on ${_lib}")
    endif()
    get_target_property(_next ${_lib} INTERFACE_LINK_LIBRARIES)
    if(_next)
      list(APPEND _todo ${_next})
    endif()
  endwhile()
endfunction()

# layer_library(NAME LINKS PUBLIC/PRIVATE ...): the static library of one folder.
function(layer_library name)
  file(GLOB _sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/backends/*.h
       ${CMAKE_CURRENT_SOURCE_DIR}/backends/*.cpp)
  add_library(${name} STATIC ${_sources})
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/devices)
  target_link_libraries(${name} ${ARGN} PRIVATE motorbench_warnings)
endfunction()

# strict_qt(TARGET): sloppy strings do not compile.
function(strict_qt target)
  target_compile_definitions(${target} PRIVATE QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_URL_CAST_FROM_STRING
    QT_NO_FOREACH QT_NO_KEYWORDS QT_DISABLE_DEPRECATED_BEFORE=0x050F00 QT_STRICT_ITERATORS)
endfunction()

function(enforce_layers)
  set(_screen Qt5::Gui Qt5::Widgets Qt5::PrintSupport QCustomPlot)
  foreach(_target async wire place)
    forbid_links(${_target} Qt5::Core ${_screen} transport model ${FAMILIES} devices widgets)
  endforeach()
  forbid_links(transport ${_screen} model ${FAMILIES} devices widgets)
  forbid_links(model ${_screen} ${FAMILIES} devices widgets)
  forbid_links(recording ${_screen} ${FAMILIES} devices widgets)
  foreach(_family ${FAMILIES})
    set(_others ${FAMILIES})
    list(REMOVE_ITEM _others ${_family})
    forbid_links(${_family} ${_screen} ${_others} devices widgets)
  endforeach()
  forbid_links(devices ${_screen} widgets)
  foreach(_target guardian motorbench-guardian)
    forbid_links(${_target} Qt5::Core ${_screen} async wire transport model ${FAMILIES} devices widgets guardianclient)
  endforeach()
  forbid_links(guardianclient ${_screen} ${FAMILIES} devices widgets)
  forbid_links(motorbenchctl ${_screen} widgets)
endfunction()
