# The build with plain CMake: the usual places, and the package that find_package() finds.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(FOURWIS_BIN_DESTINATION ${CMAKE_INSTALL_BINDIR})
set(FOURWIS_INCLUDE_DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME})
set(FOURWIS_LIB_DESTINATION ${CMAKE_INSTALL_LIBDIR})
set(FOURWIS_SHARE_DESTINATION ${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME})
set(FOURWIS_CMAKE_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/${PROJECT_NAME})
set(FOURWIS_PACKAGE_DIR ${PROJECT_BINARY_DIR}/cmake)

set(package ${FOURWIS_PACKAGE_DIR}/${PROJECT_NAME}Config)
configure_file(cmake/${PROJECT_NAME}-extras.cmake.in ${package}.cmake @ONLY)
write_basic_package_version_file(${package}Version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${package}.cmake ${package}Version.cmake DESTINATION ${FOURWIS_CMAKE_DESTINATION})

# A project that has this one as a part of it wants neither.
if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR)
  include(CTest)
  set(FOURWIS_TESTING ${BUILD_TESTING})
  set(FOURWIS_EXAMPLES ON)
endif()
