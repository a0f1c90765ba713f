# cmake --install: the library for find_package(rayproof), the laboratory as a component of that package, and the front
# door over the programs (cmake/targets.cmake).
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/rayproof)

install(DIRECTORY lib/include/rayproof DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
install(TARGETS rayproof EXPORT rayproofTargets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(EXPORT rayproofTargets NAMESPACE rayproof:: DESTINATION ${package} COMPONENT library)

configure_package_config_file(cmake/rayproofConfig.cmake.in rayproofConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(rayproofConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/rayproofConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/rayproofConfigVersion.cmake
        DESTINATION ${package} COMPONENT library)

if(TARGET rayproof_properties)
  set_target_properties(rayproof_properties PROPERTIES EXPORT_NAME laboratory)
  install(TARGETS rayproof_properties rayproof_oracle rayproof_subjects rayproof_generators rayproof_case
          EXPORT rayproofLaboratory ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT laboratory
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT laboratory)
  install(EXPORT rayproofLaboratory NAMESPACE rayproof:: DESTINATION ${package} COMPONENT laboratory)
  set(headers ${PROJECT_BINARY_DIR}/laboratory-headers)
  install(CODE "set(source \"${PROJECT_SOURCE_DIR}/property_tests\")
                set(headers \"${headers}\")
                include(\"${PROJECT_SOURCE_DIR}/cmake/laboratory-headers.cmake\")" COMPONENT laboratory)
  install(DIRECTORY ${headers}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT laboratory)
endif()

if(RAYPROOF_LAB)
  install(PROGRAMS cmake/front-door.sh DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME rayproof COMPONENT programs)
  install(FILES cmake/commands.txt DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/rayproof COMPONENT programs)
  include(cmake/labs.cmake)
  include(cmake/docs.cmake)
endif()
