# Two components: the program with all that it needs at run time, and the library for programs of one's own.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
set(TOWFORM_DATA ${CMAKE_INSTALL_DATADIR}/towform)

install(TARGETS towform_program)
install(DIRECTORY meshes cases DESTINATION ${TOWFORM_DATA})
# What the program says of itself: man page, completions and schema.
set(TOWFORM_ZSH_COMPLETIONS ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING
  "Where zsh looks for completions (Debian's packages: share/zsh/vendor-completions)")
foreach(paper "towform.1|manual|${CMAKE_INSTALL_MANDIR}/man1" "towform|completion;bash|${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
    "_towform|completion;zsh|${TOWFORM_ZSH_COMPLETIONS}"
    "case.schema.json|schema|${TOWFORM_DATA}")
  string(REPLACE "|" ";" paper "${paper}")
  list(GET paper 0 name)
  list(GET paper -1 place)
  list(SUBLIST paper 1 -1 words)
  list(REMOVE_AT words -1)
  set(file ${PROJECT_BINARY_DIR}/papers/${name})
  add_custom_command(TARGET towform_program POST_BUILD
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/papers
    COMMAND $<TARGET_FILE:towform_program> ${words} > ${file} VERBATIM)
  install(FILES ${file} DESTINATION ${place})
endforeach()
# What `towform study` starts, found relative to the program, and the tools for Python.
install(DIRECTORY tools/study DESTINATION ${TOWFORM_DATA}/tools USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
install(FILES tools/towform_results.py DESTINATION ${TOWFORM_DATA}/tools)
install(PROGRAMS tools/plot.py DESTINATION ${TOWFORM_DATA}/tools)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(TARGETS towform towform_options EXPORT towformTargets COMPONENT library)
install(DIRECTORY include/towform DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libtowform-dev COMPONENT library)
install(EXPORT towformTargets NAMESPACE towform:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/towform COMPONENT library)
configure_package_config_file(cmake/towformConfig.cmake.in ${PROJECT_BINARY_DIR}/towformConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/towform)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/towformConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/Findlibdeflate.cmake ${PROJECT_BINARY_DIR}/towformConfig.cmake ${PROJECT_BINARY_DIR}/towformConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/towform COMPONENT library)
