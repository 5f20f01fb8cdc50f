include(CMakePackageConfigHelpers)
install(TARGETS thigma EXPORT thigmaTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/thigma DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(TARGET thigma_program)
  install(TARGETS thigma_program DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(EXPORT thigmaTargets NAMESPACE thigma:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/thigma)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/thigmaConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/thigmaConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/thigma)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/thigmaConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/thigmaConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/thigmaConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/thigma)
