# SPDX-License-Identifier: Apache-2.0
# cmake --install: libraries and headers by their own rules (osgtrainer_library), here what find_package needs.
# Files are installed as found: find_package(osgTrainer COMPONENTS viewlod osgTerrainROAM_core …), and for other build tools
# pkg-config osgTrainer-viewlod.
include(CMakePackageConfigHelpers)

set(OSGTRAINER_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/osgTrainer)
get_property(OSGTRAINER_COMPONENTS GLOBAL PROPERTY OSGTRAINER_COMPONENTS)
configure_package_config_file(cmake/osgTrainerConfig.cmake.in ${PROJECT_BINARY_DIR}/osgTrainerConfig.cmake
    INSTALL_DESTINATION ${OSGTRAINER_PACKAGE_DIR} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/osgTrainerConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/osgTrainerConfig.cmake ${PROJECT_BINARY_DIR}/osgTrainerConfigVersion.cmake
    ${PROJECT_SOURCE_DIR}/cmake/OsgTarget.cmake
    DESTINATION ${OSGTRAINER_PACKAGE_DIR})
install(EXPORT osgTrainerTargets NAMESPACE osgTrainer:: DESTINATION ${OSGTRAINER_PACKAGE_DIR})
include(PkgConfigFiles)
