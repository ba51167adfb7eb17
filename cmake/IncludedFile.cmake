# SPDX-License-Identifier: Apache-2.0
# Shared by CheckLayering and CheckIncludeCycles; needs ROOT.

file(GLOB includeFolders LIST_DIRECTORIES true RELATIVE "${ROOT}" "${ROOT}/osg*/src" "${ROOT}/osg*/src/core/*" "${ROOT}/tests/core/*"
    "${ROOT}/tests/osg/*")
list(PREPEND includeFolders . apps apps/trainer osgSession tests/support data data/generator bench)

# The path of a file below ROOT, normal, if it is there; else nothing.
function(fileBelowRoot candidate out)
    set(${out} "" PARENT_SCOPE)
    cmake_path(NORMAL_PATH candidate)
    if(EXISTS "${ROOT}/${candidate}" AND NOT IS_DIRECTORY "${ROOT}/${candidate}")
        set(${out} "${candidate}" PARENT_SCOPE)
    endif()
endfunction()

# The file that a name means in the include folders, or nothing; looked for once for each name.
function(fileOfFolders target out)
    get_property(isKnown GLOBAL PROPERTY "file of ${target}" SET)
    if(NOT isKnown)
        string(REGEX MATCH "^[^/]+" component "${target}")
        list(TRANSFORM includeFolders APPEND "/${target}" OUTPUT_VARIABLE candidates)
        foreach(candidate "${component}/include/${target}" ${candidates})
            fileBelowRoot("${candidate}" found)
            if(NOT found STREQUAL "")
                break()
            endif()
        endforeach()
        set_property(GLOBAL PROPERTY "file of ${target}" "${found}")
    endif()
    get_property(found GLOBAL PROPERTY "file of ${target}")
    set(${out} "${found}" PARENT_SCOPE)
endfunction()

# The file of the tree, relative to ROOT, that an include line of `includer` names; nothing for another file. Looks beside
# the including file, then in the include folders.
function(includedFile includer target out)
    cmake_path(GET includer PARENT_PATH folder)
    fileBelowRoot("${folder}/${target}" found)
    if(found STREQUAL "")
        fileOfFolders("${target}" found)
    endif()
    set(${out} "${found}" PARENT_SCOPE)
endfunction()
