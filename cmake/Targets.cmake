# SPDX-License-Identifier: Apache-2.0
# One way to declare each kind of target, so that include paths, warnings and names cannot drift apart.

# The targets that compute by the million: they alone are optimised as the build type says (decision 78).
set(OSGTRAINER_HOT osgPMObjects_core osgPMObjects_tools_core osgTerrainROAM_core osgTerrainROAM_bisection_core osgMultiTriangulation_core
    osgMultiTriangulation_tools_core osgRoads_core scenery worldmaking terrain_generator)

# osgtrainer_even_units(TARGET MOST): a unity build joins the sources of the target in as few units of at most MOST sources as hold them, each of about
# the same size: a small last one would read all headers once more.
function(osgtrainer_even_units target most)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    list(LENGTH sources count)
    if(NOT CMAKE_UNITY_BUILD OR count LESS 2)
        return()
    endif()
    math(EXPR units "(${count} + ${most} - 1) / ${most}")
    math(EXPR size "(${count} + ${units} - 1) / ${units}")
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${size})
endfunction()

# What holds for every target of the tree: warnings, and the same rounding everywhere (a fused multiply-add would make
# pictures and meshes depend on the CPU).
function(osgtrainer_common target)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:osgTrainer_warnings>)
    target_compile_options(${target} PRIVATE -ffp-contract=off)
    if(NOT target IN_LIST OSGTRAINER_HOT)
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
    osgtrainer_even_units(${target} "${CMAKE_UNITY_BUILD_BATCH_SIZE}")
endfunction()

# osgtrainer_install_if_built(TARGET KIND DESTINATION): installs a program or module. One that was not built is left out with a
# line that names it, so that `cmake --install` works after `cmake --build build --target libraries`.
function(osgtrainer_install_if_built target kind destination)
    install(CODE "if(NOT EXISTS \"$<TARGET_FILE:${target}>\")
    message(STATUS \"Not installed, because it was not built: ${target}\")\nendif()")
    install(TARGETS ${target} ${kind} DESTINATION ${destination} OPTIONAL)
endfunction()

# The target `libraries`: all libraries and plugins, without the programs. An installation needs no more.
if(PROJECT_IS_TOP_LEVEL)
    set(OSGTRAINER_LIBRARIES_TARGET libraries)
else()
    set(OSGTRAINER_LIBRARIES_TARGET osgTrainer_libraries) # the short name may be the other project's
endif()
add_custom_target(${OSGTRAINER_LIBRARIES_TARGET})

# osgtrainer_without_graphics(TARGET): the target must not see OSG, OpenGL, EGL or X11: headers that end the compilation
# stand in front of theirs. The test `layering` reads include lines; this holds for what other headers include, too.
function(osgtrainer_without_graphics target)
    target_include_directories(${target} BEFORE PRIVATE $<BUILD_INTERFACE:${OSGTRAINER_FORBIDDEN_HEADERS}>)
endfunction()

# osgtrainer_library(NAME INCLUDE dir SOURCES … LINK … PRIVATE …): a static library, its alias osgTrainer::NAME, its
# install rules. NAME is a component of the package; a name that ends in _core installs the headers below core/ alone.
function(osgtrainer_library name)
    cmake_parse_arguments(arg "" "INCLUDE" "SOURCES;LINK;PRIVATE" ${ARGN})
    add_library(${name} STATIC ${arg_SOURCES})
    add_library(osgTrainer::${name} ALIAS ${name})
    target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${arg_INCLUDE}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE ${arg_PRIVATE})
    target_compile_features(${name} PUBLIC cxx_std_20)
    osgtrainer_common(${name})

    set_property(GLOBAL APPEND PROPERTY OSGTRAINER_COMPONENTS ${name})
    add_dependencies(${OSGTRAINER_LIBRARIES_TARGET} ${name})
    install(TARGETS ${name} EXPORT osgTrainerTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    if(name MATCHES "_core$")
        osgtrainer_without_graphics(${name})
        install(DIRECTORY ${arg_INCLUDE}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING REGEX "/core/.*\\.h$")
    else()
        install(DIRECTORY ${arg_INCLUDE}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    endif()
endfunction()

# osgtrainer_headers(NAME LINK …): a header-only library in include/, its alias and its install rules.
function(osgtrainer_headers name)
    cmake_parse_arguments(arg "" "" "LINK" ${ARGN})
    add_library(${name} INTERFACE)
    add_library(osgTrainer::${name} ALIAS ${name})
    target_include_directories(${name} INTERFACE
        $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${name} INTERFACE ${arg_LINK})
    target_compile_features(${name} INTERFACE cxx_std_20)
    set_property(GLOBAL APPEND PROPERTY OSGTRAINER_COMPONENTS ${name})
    install(TARGETS ${name} EXPORT osgTrainerTargets)
    install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# osgtrainer_part(NAME [WITHOUT_GRAPHICS] [INSTALL] [INCLUDE dir] SOURCES … LINK … PRIVATE …): a static library of this tree alone,
# included by the path from INCLUDE (default: the root of the tree). INSTALL: a library that is installed stands on it, so its
# archive is installed, too, as osgTrainer_NAME, without headers.
function(osgtrainer_part name)
    cmake_parse_arguments(arg "WITHOUT_GRAPHICS;INSTALL" "INCLUDE" "SOURCES;LINK;PRIVATE" ${ARGN})
    if(NOT arg_INCLUDE)
        set(arg_INCLUDE ${PROJECT_SOURCE_DIR})
    endif()
    add_library(${name} STATIC ${arg_SOURCES})
    target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${arg_INCLUDE}>)
    target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE ${arg_PRIVATE})
    osgtrainer_common(${name})
    if(arg_WITHOUT_GRAPHICS)
        osgtrainer_without_graphics(${name})
    endif()
    if(arg_INSTALL)
        set_target_properties(${name} PROPERTIES OUTPUT_NAME osgTrainer_${name})
        set_property(GLOBAL APPEND PROPERTY OSGTRAINER_INSTALLED_PARTS ${name})
        add_dependencies(${OSGTRAINER_LIBRARIES_TARGET} ${name})
        install(TARGETS ${name} EXPORT osgTrainerTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    endif()
endfunction()

# osgtrainer_program(NAME [INSTALL] SOURCES … LINK …): a program, told its version as OSGTRAINER_VERSION.
function(osgtrainer_program name)
    cmake_parse_arguments(arg "INSTALL" "" "SOURCES;LINK" ${ARGN})
    add_executable(${name} ${arg_SOURCES})
    target_link_libraries(${name} PRIVATE ${arg_LINK})
    target_compile_definitions(${name} PRIVATE OSGTRAINER_VERSION="${PROJECT_VERSION}")
    osgtrainer_common(${name})
    if(arg_INSTALL)
        osgtrainer_install_if_built(${name} RUNTIME ${CMAKE_INSTALL_BINDIR})
    endif()
endfunction()

# osgtrainer_osg_plugin(NAME SOURCES … LINK …): a module where osgDB looks for it: osgPlugins-VERSION/NAME.so below each
# folder of OSG_LIBRARY_PATH. osgdb_EXTENSION reads files of that extension; osgdb_serializers_NAMESPACE is loaded when
# a scene file names a class that osgDB does not know.
function(osgtrainer_osg_plugin name)
    cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
    set(folder osgPlugins-${OPENSCENEGRAPH_VERSION})
    add_library(${name} MODULE ${arg_SOURCES})
    target_link_libraries(${name} PRIVATE ${arg_LINK})
    osgtrainer_common(${name})
    set_target_properties(${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${folder})
    add_dependencies(${OSGTRAINER_LIBRARIES_TARGET} ${name})
    osgtrainer_install_if_built(${name} LIBRARY ${CMAKE_INSTALL_LIBDIR}/${folder})
endfunction()
