# What makes builds shorter. Sources with compile options of their own stay as they are.

# towform_precompile(TARGET [HEADER]...): what nearly every source of a target reads anyway is read once. Headers from
# outside only, so that no edit of ours compiles them again.
function(towform_precompile target)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional>
    <map> <memory> <optional> <span> <sstream> <string> <string_view> <utility> <variant> <vector> <fmt/format.h> ${ARGN})
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_source_file_property(own_options ${source} COMPILE_OPTIONS)
    if(own_options)
      set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endfunction()

# towform_unite_rooms(TARGET): each directory of sources is compiled as one, which reads every header and instantiates
# every template once. An edit then compiles its room again: for builds from nothing. In a room no two sources may use a
# name in their anonymous namespaces for different things.
function(towform_unite_rooms target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/src OUTPUT_VARIABLE room)
    string(REGEX REPLACE "/.*" "" room ${room})
    get_source_file_property(own_options ${source} COMPILE_OPTIONS)
    if(NOT own_options)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room})
    endif()
  endforeach()
endfunction()
