# SPDX-License-Identifier: Apache-2.0
# cmake -DROOT=tree -P CheckLayering.cmake: reads the include lines of the tree and fails on a breach of the arrows
# in docs/architecture.md, or when a layer that must be there matches no file (a check of nothing passes always).
# Not linking OSG would not keep it out of a core: its headers lie in the system include path.
cmake_minimum_required(VERSION 3.25)
if(NOT IS_DIRECTORY "${ROOT}")
    message(FATAL_ERROR "layering: -DROOT= names no folder: '${ROOT}'")
endif()
get_filename_component(ROOT "${ROOT}" REALPATH)
include(${CMAKE_CURRENT_LIST_DIR}/IncludedFile.cmake)

# A layer: a regular expression of its files (relative to ROOT, first match wins) and the layers that it may include
# besides itself. "graphics" are the headers of OSG, OpenGL, EGL and GLX; whatever else is outside the tree is free.
set(layers)
macro(layer name files)
    list(APPEND layers ${name})
    set(${name}_files "${files}")
    set(${name}_may ${ARGN})
    set(${name}_count 0)
endmacro()

layer(foundation     "^foundation/")
layer(viewlod        "^viewlod/")
layer(objects-core   "^osgPMObjects/(include/osgPMObjects|src)/core/"     foundation viewlod)
layer(terrain-core   "^osgTerrainROAM/(include/osgTerrainROAM|src)/core/" foundation viewlod objects-core)
layer(simulation     "^simulation/"        foundation viewlod)
layer(models         "^scenery/models/"    foundation objects-core)
layer(placement      "^scenery/placement/" foundation viewlod objects-core models)
layer(terminal       "^apps/terminal/"     foundation)
layer(ground         "^apps/ground/"       foundation viewlod objects-core terrain-core simulation)
layer(generator      "^data/generator/"    foundation)
layer(render-support "^tests/support/Rendered" graphics foundation viewlod objects-core terrain-core simulation models objects
    terrain offscreen trainer test-support)
layer(test-support   "^tests/support/"     foundation viewlod objects-core terrain-core simulation generator)
layer(core-tests     "^tests/(core|fuzz)/" foundation viewlod objects-core terrain-core simulation models placement generator
    test-support)
layer(traversal      "^osgTraversal/"      graphics foundation viewlod)
layer(objects        "^osgPMObjects/"      graphics foundation viewlod objects-core traversal)
layer(terrain        "^osgTerrainROAM/"    graphics foundation viewlod objects-core terrain-core objects traversal)
layer(offscreen      "^osgOffscreen/"      graphics foundation viewlod)
layer(trainer        "^apps/trainer/"      graphics foundation viewlod objects-core terrain-core simulation models placement objects
    terrain offscreen terminal ground)
layer(tools          "^apps/"              graphics foundation viewlod objects-core terrain-core simulation objects terrain
    offscreen terminal ground)
set(required foundation viewlod objects-core traversal objects terrain-core simulation models placement generator core-tests
    terrain offscreen trainer tools)

set(graphics_includes "^(osg|osg[A-Z][A-Za-z]*|OpenThreads|GL|GLES[0-9]*|EGL|KHR|X11)/")

# The layer of a path relative to ROOT, or nothing.
function(layerOfPath path out)
    set(${out} "" PARENT_SCOPE)
    foreach(name IN LISTS layers)
        if(path MATCHES "${${name}_files}")
            set(${out} ${name} PARENT_SCOPE)
            return()
        endif()
    endforeach()
endfunction()

# The layer of what an include line names: a file of the tree, seen from the including file or from an include
# folder, graphics, or nothing (standard library, third party).
function(layerOfInclude includer target out)
    set(${out} "" PARENT_SCOPE)
    string(REGEX MATCH "^[^/]+" component "${target}")
    includedFile("${includer}" "${target}" file)
    if(NOT file STREQUAL "")
        layerOfPath("${file}" found)
        set(${out} "${found}" PARENT_SCOPE)
    elseif(target MATCHES "^(osgTerrainROAM|osgPMObjects|osgOffscreen|osgTraversal)/")
        layerOfPath("${component}/include/${target}" found) # a header that is not there still shows the intent
        set(${out} "${found}" PARENT_SCOPE)
    elseif(target MATCHES "${graphics_includes}")
        set(${out} graphics PARENT_SCOPE)
    endif()
endfunction()

file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/foundation/*" "${ROOT}/viewlod/*" "${ROOT}/osg*/*"
    "${ROOT}/simulation/*" "${ROOT}/scenery/*" "${ROOT}/apps/*" "${ROOT}/tests/*" "${ROOT}/data/generator/*")
set(breaches)
set(lineCount 0)
foreach(file IN LISTS files)
    get_filename_component(extension "${file}" LAST_EXT)
    if(NOT (extension STREQUAL "" OR extension MATCHES "^\\.(h|hpp|cpp|inl)$"))
        continue()
    endif()
    layerOfPath("${file}" from)
    if(from STREQUAL "")
        continue()
    endif()
    math(EXPR ${from}_count "${${from}_count} + 1")
    file(STRINGS "${ROOT}/${file}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]")
    foreach(line IN LISTS lines)
        math(EXPR lineCount "${lineCount} + 1")
        string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]+).*$" "\\1" target "${line}")
        layerOfInclude("${file}" "${target}" to)
        if(NOT to STREQUAL "" AND NOT to STREQUAL from AND NOT to IN_LIST ${from}_may)
            list(APPEND breaches "${file}: ${from} must not include ${to} (<${target}>)")
        endif()
    endforeach()
endforeach()

foreach(name IN LISTS required)
    if(${name}_count EQUAL 0)
        list(APPEND breaches "${name}: no file matches ${${name}_files}")
    endif()
endforeach()
if(lineCount EQUAL 0)
    list(APPEND breaches "no include line was read")
endif()
if(breaches)
    list(JOIN breaches "\n  " text)
    message(FATAL_ERROR "layering:\n  ${text}")
endif()

set(summary)
foreach(name IN LISTS layers)
    string(APPEND summary " ${name} ${${name}_count}")
endforeach()
message(STATUS "layering: ${lineCount} include lines, no breach; files:${summary}")
