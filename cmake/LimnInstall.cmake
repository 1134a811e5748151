# `cmake --install` puts the program, the library limn::core and its headers in place, with a
# package file so that find_package(limn) works for whoever embeds it.
include(CMakePackageConfigHelpers)

install(TARGETS limn_core limn_options EXPORT limn-targets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/limn DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT limn-targets NAMESPACE limn:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limn)
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/limn-config.cmake.in ${PROJECT_BINARY_DIR}/limn-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limn)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/limn-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/limn-config.cmake ${PROJECT_BINARY_DIR}/limn-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limn)
if(LIMN_BUILD_APP)
  install(TARGETS limn RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
