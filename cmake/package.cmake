# Debian packages: towform, and libtowform-dev for programs of one's own. scripts/package builds and tries them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "towform")
set(CPACK_PACKAGE_CONTACT "The towform authors <towform@localhost>" CACHE STRING "Maintainer of the packages")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME towform)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Shear, draw-in, wrinkling and force of a sheet formed between rigid tools: an
explicit finite-element solver with a material predicted from the sheet's
constituents, reports in 3-D, and studies of many runs.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Forming and reporting need no Python. Studies and the tools for results do; the search for a best run alone needs Optuna.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS
  "python3, python3-h5py, python3-jinja2, python3-matplotlib, python3-numpy, python3-scipy, snakemake")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "python3-optuna, paraview")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libtowform-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "Headers and static library for programs that form cases themselves, with shear
laws of their own.")
# What towformConfig.cmake looks for.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libdeflate-dev, libeigen3-dev, libfcl-dev, libfmt-dev, libhdf5-dev, \
libspdlog-dev, libssl-dev, libtomlplusplus-dev, nlohmann-json3-dev")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "towform, cmake")

# Each with its licence; that of the bundled 3-D view's three.js stands in the bundle, and in every report.
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/towform RENAME copyright)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libtowform-dev RENAME copyright COMPONENT library)
include(CPack)
