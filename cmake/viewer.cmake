# The 3-D view of reports: three.js, bundled by esbuild from tools/viewer when Node and npm are there and npm can fetch
# what the lock file names. Without them reports are written without the view, and say so.
set(viewer_source ${PROJECT_SOURCE_DIR}/tools/viewer)
set(viewer_build ${PROJECT_BINARY_DIR}/viewer)
option(TOWFORM_VIEWER_WANTED "Bundle the 3-D view of reports when Node and npm are there" ON)
find_program(TOWFORM_NODE node)
find_program(TOWFORM_NPM npm)

function(towform_fetch_viewer_packages)
  set(TOWFORM_VIEWER_PROBLEM "" PARENT_SCOPE)
  if(NOT TOWFORM_VIEWER_WANTED)
    set(TOWFORM_VIEWER_PROBLEM "it was not wanted" PARENT_SCOPE)
    return()
  endif()
  if(NOT TOWFORM_NODE OR NOT TOWFORM_NPM)
    set(TOWFORM_VIEWER_PROBLEM "Node or npm is not there (scripts/packages-viewer)" PARENT_SCOPE)
    return()
  endif()
  file(SHA256 ${viewer_source}/package-lock.json lock)
  set(stamp ${viewer_build}/fetched)
  if(EXISTS ${stamp})
    file(READ ${stamp} fetched)
    if(fetched STREQUAL lock)
      return()
    endif()
  endif()
  file(COPY ${viewer_source}/package.json ${viewer_source}/package-lock.json ${viewer_source}/.npmrc
    DESTINATION ${viewer_build})
  message(STATUS "Fetching the packages of the 3-D view with npm")
  execute_process(COMMAND ${TOWFORM_NPM} ci --ignore-scripts --prefer-offline --fetch-retries=1
    WORKING_DIRECTORY ${viewer_build} TIMEOUT 180 RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE error)
  if(NOT result EQUAL 0)
    string(REGEX MATCH "[^\n]+" first "${error}")
    set(TOWFORM_VIEWER_PROBLEM "npm could not fetch its packages: ${first}" PARENT_SCOPE)
    return()
  endif()
  file(WRITE ${stamp} ${lock})
endfunction()
towform_fetch_viewer_packages()

if(TOWFORM_VIEWER_PROBLEM)
  message(STATUS "Reports will have no 3-D view: ${TOWFORM_VIEWER_PROBLEM}")
  set(TOWFORM_VIEWER ${viewer_build}/none.js)
  file(WRITE ${TOWFORM_VIEWER} "")
else()
  message(STATUS "Reports will have a 3-D view")
  set(TOWFORM_VIEWER ${viewer_build}/viewer.js)
  file(GLOB viewer_files CONFIGURE_DEPENDS ${viewer_source}/src/*.js)
  add_custom_command(OUTPUT ${TOWFORM_VIEWER} DEPENDS ${viewer_files} ${viewer_build}/fetched
    COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${viewer_build}/node_modules ${viewer_build}/node_modules/.bin/esbuild
      ${viewer_source}/src/main.js --bundle --minify --format=iife --target=es2022 --charset=ascii --legal-comments=inline
      --log-level=warning --outfile=${TOWFORM_VIEWER}
    COMMENT "Bundling the 3-D view" VERBATIM)
endif()

set(TOWFORM_RESOURCES ${PROJECT_BINARY_DIR}/generated/resources.cpp)
configure_file(${PROJECT_SOURCE_DIR}/cmake/resources.cpp.in ${TOWFORM_RESOURCES} @ONLY)
set_source_files_properties(${TOWFORM_RESOURCES} TARGET_DIRECTORY towform PROPERTIES
  OBJECT_DEPENDS "${TOWFORM_VIEWER};${PROJECT_SOURCE_DIR}/src/report/page.css")
