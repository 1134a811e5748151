# `cmake --install` puts the program, the library limn::core and its headers in place, with a
# package file so that find_package(limn) works for whoever embeds it. Components: library, program.
include(CMakePackageConfigHelpers)

install(TARGETS limn_core limn_options EXPORT limn-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/limn
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
install(EXPORT limn-targets NAMESPACE limn::
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limn COMPONENT library)
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/limn-config.cmake.in ${PROJECT_BINARY_DIR}/limn-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limn)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/limn-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/limn-config.cmake ${PROJECT_BINARY_DIR}/limn-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/limn COMPONENT library)
if(LIMN_BUILD_APP)
  install(TARGETS limn RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()
