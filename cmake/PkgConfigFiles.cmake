# SPDX-License-Identifier: Apache-2.0
# Files for pkg-config, one a component: pkg-config --cflags --libs osgTrainer-osgTerrainROAM. They follow from the CMake targets.
# The libraries are static, so what they are linked with stands in Requires and Libs, not in the .private fields. The prefix is
# found from the file's own folder: an installation can be moved.

# Adds to the lists `requires` and `libs` of the caller what a link item of a target becomes. An item without a rule is an error.
function(osgtrainer_pc_item item)
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" item "${item}")
    if(item STREQUAL "" OR item MATCHES "^\\$<(BUILD_INTERFACE|TARGET_OBJECTS):")
        return()
    elseif(item STREQUAL "osgTrainer::osg")
        foreach(part osgTerrain osgViewer osgGA osgUtil osgDB osg)
            list(APPEND requires openscenegraph-${part})
        endforeach()
        list(APPEND requires openthreads)
    elseif(item MATCHES "^osgTrainer::(.*)$")
        list(APPEND requires osgTrainer-${CMAKE_MATCH_1})
    elseif(item STREQUAL "Threads::Threads")
        list(APPEND libs -pthread)
    elseif(item STREQUAL "meshoptimizer::meshoptimizer")
        list(APPEND libs -lmeshoptimizer) # has no .pc file in Debian 12
    elseif(item MATCHES "^(glm|GDAL|TinyGLTF|ZLIB)::")
        string(TOLOWER "${CMAKE_MATCH_1}" package)
        list(APPEND requires ${package})
    elseif(item MATCHES "GeographicLib")
        list(APPEND requires geographiclib)
    elseif(item MATCHES "^[A-Za-z0-9_]+$")
        list(APPEND libs -l${item})
    else()
        message(FATAL_ERROR "cmake/PkgConfigFiles.cmake: '${item}' has no name for pkg-config; add a rule for it")
    endif()
    set(requires ${requires} PARENT_SCOPE)
    set(libs ${libs} PARENT_SCOPE)
endfunction()

# osgtrainer_pc_file(COMPONENT): writes and installs osgTrainer-COMPONENT.pc.
function(osgtrainer_pc_file component)
    set(requires)
    set(libs)
    get_target_property(type ${component} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
        list(APPEND libs -l${component})
    endif()
    get_target_property(options ${component} INTERFACE_LINK_OPTIONS)
    if(options)
        list(TRANSFORM options REPLACE "^LINKER:" "-Wl,")
        list(PREPEND libs ${options}) # in front of the libraries, as CMake has them
    endif()
    get_target_property(items ${component} INTERFACE_LINK_LIBRARIES)
    foreach(item IN LISTS items)
        if(item)
            osgtrainer_pc_item("${item}")
        endif()
    endforeach()
    list(REMOVE_DUPLICATES requires)
    list(JOIN requires " " requires)
    list(JOIN libs " " libs)
    set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
    file(RELATIVE_PATH up "/${folder}" "/")
    string(REGEX REPLACE "/$" "" up "${up}")
    set(file ${PROJECT_BINARY_DIR}/pkgconfig/osgTrainer-${component}.pc)
    file(WRITE ${file} "prefix=\${pcfiledir}/${up}\nlibdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}\n"
        "includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}\n\nName: osgTrainer-${component}\n"
        "Description: ${PROJECT_DESCRIPTION} (needs C++20)\nVersion: ${PROJECT_VERSION}\n"
        "Requires: ${requires}\nLibs: -L\${libdir} ${libs}\nCflags: -I\${includedir}\n")
    install(FILES ${file} DESTINATION ${folder})
endfunction()

get_property(components GLOBAL PROPERTY OSGTRAINER_COMPONENTS)
foreach(component IN LISTS components)
    osgtrainer_pc_file(${component})
endforeach()
