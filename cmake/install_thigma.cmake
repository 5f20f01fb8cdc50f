include(CMakePackageConfigHelpers)
# Components: library (libthigma_c.so), development (C++ and C), program.
install(TARGETS thigma EXPORT thigmaTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
# The front door, what cmake/installed_headers.txt names, and what these include; no inner folder.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/installed_headers.txt)
execute_process(COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/installed_headers.py
                OUTPUT_VARIABLE headers OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" headers "${headers}")
foreach(header IN LISTS headers)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${PROJECT_SOURCE_DIR}/src/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder}
          COMPONENT development)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT development)
if(TARGET thigma_program)
  install(TARGETS thigma_program DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()
install(EXPORT thigmaTargets NAMESPACE thigma:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/thigma
        COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/thigmaConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/thigmaConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/thigma)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/thigmaConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/thigmaConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/thigmaConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/thigma COMPONENT development)
