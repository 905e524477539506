# Options of our own targets; nothing here reaches a user of the installed library.
add_library(towform_options INTERFACE)
target_compile_options(towform_options INTERFACE
  -Wall -Wextra -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
  $<$<BOOL:${TOWFORM_WARNINGS_AS_ERRORS}>:-Werror>
  # One source may shadow what another names; builds of single sources warn.
  $<$<NOT:$<BOOL:${TOWFORM_UNITY}>>:-Wshadow>
  # The same bits from every compiler and for every number of threads.
  -ffp-contract=off
  $<$<CONFIG:Debug>:-D_GLIBCXX_ASSERTIONS>
  $<$<BOOL:${TOWFORM_FLOAT_TRAPS}>:-DTOWFORM_FLOAT_TRAPS=1>)
# For files whose loops vectorise. Nothing here changes a bit of a result: square roots of negative numbers set no
# errno, choices between values need no branches, and where there are vectors of 512 bits they are used.
set(TOWFORM_VECTOR_OPTIONS -fno-math-errno -fno-trapping-math)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND TOWFORM_VECTOR_OPTIONS -mprefer-vector-width=512)
endif()
if(TOWFORM_SANITIZE)
  add_compile_options(-fsanitize=${TOWFORM_SANITIZE} -fno-omit-frame-pointer)
  # g++ 12 sees uninitialized values in the standard library's own headers once they are instrumented.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(towform_options INTERFACE -Wno-maybe-uninitialized)
  endif()
  add_link_options(-fsanitize=${TOWFORM_SANITIZE})
endif()

# What a result needs to say where it came from.
execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} describe --always --dirty --abbrev=12
  OUTPUT_VARIABLE TOWFORM_GIT_HASH OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT TOWFORM_GIT_HASH)
  set(TOWFORM_GIT_HASH "unknown")
endif()
set(TOWFORM_FLAGS "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_BUILD_TYPE} ${CMAKE_CXX_FLAGS}")
configure_file(cmake/version.hpp.in ${PROJECT_BINARY_DIR}/generated/version.hpp)
target_include_directories(towform_options INTERFACE $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>)

# towform_keep_traps(TARGET): sources that may compute both sides of a choice, to vectorise, compute the one they need.
function(towform_keep_traps target)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_source_file_property(own_options ${source} COMPILE_OPTIONS)
    if(own_options)
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS -ftrapping-math)
    endif()
  endforeach()
endfunction()
