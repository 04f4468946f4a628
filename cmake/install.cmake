# What `cmake --install` puts where: headers, the library, and what find_package and pkg-config read. All of it may be
# moved afterwards, unless CMAKE_INSTALL_LIBDIR or CMAKE_INSTALL_INCLUDEDIR is absolute.
include(CMakePackageConfigHelpers)

install(TARGETS hatbox EXPORT hatbox_targets)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY include/hatbox ${PROJECT_BINARY_DIR}/include/hatbox DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

set(hatbox_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/hatbox)
if(BUILD_SHARED_LIBS)
  set(hatbox_library_kind shared)
else()
  set(hatbox_library_kind static)
endif()
install(EXPORT hatbox_targets FILE hatbox-targets.cmake NAMESPACE hatbox:: DESTINATION ${hatbox_config_dir})
configure_package_config_file(cmake/hatbox-config.cmake.in hatbox-config.cmake
  INSTALL_DESTINATION ${hatbox_config_dir})
write_basic_package_version_file(hatbox-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/hatbox-config.cmake ${PROJECT_BINARY_DIR}/hatbox-config-version.cmake
  DESTINATION ${hatbox_config_dir})

set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
  set(pkgconfig_prefix ${CMAKE_INSTALL_PREFIX})
else()
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX}/${pkgconfig_dir}
    OUTPUT_VARIABLE up)
  set(pkgconfig_prefix "\${pcfiledir}/${up}")
endif()
# An absolute directory replaces what it is appended to.
cmake_path(APPEND pkgconfig_libdir "\${prefix}" "${CMAKE_INSTALL_LIBDIR}")
cmake_path(APPEND pkgconfig_includedir "\${prefix}" "${CMAKE_INSTALL_INCLUDEDIR}")
configure_file(cmake/hatbox.pc.in hatbox.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/hatbox.pc DESTINATION ${pkgconfig_dir})
