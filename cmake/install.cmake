include(CMakePackageConfigHelpers)
install(TARGETS towform towform_options EXPORT towformTargets)
install(TARGETS towform_program)
install(DIRECTORY include/towform DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY meshes cases DESTINATION ${CMAKE_INSTALL_DATADIR}/towform)
# What `towform study` starts, found relative to the program.
install(DIRECTORY tools/study DESTINATION ${CMAKE_INSTALL_DATADIR}/towform/tools USE_SOURCE_PERMISSIONS
  PATTERN __pycache__ EXCLUDE)
install(FILES tools/towform_results.py DESTINATION ${CMAKE_INSTALL_DATADIR}/towform/tools)
install(EXPORT towformTargets NAMESPACE towform:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/towform)
configure_package_config_file(cmake/towformConfig.cmake.in ${PROJECT_BINARY_DIR}/towformConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/towform)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/towformConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/towformConfig.cmake ${PROJECT_BINARY_DIR}/towformConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/towform)
