# SPDX-License-Identifier: Apache-2.0
# Shared by CheckLayering and CheckIncludeCycles; needs ROOT.

file(GLOB includeFolders LIST_DIRECTORIES true RELATIVE "${ROOT}" "${ROOT}/osg*/src" "${ROOT}/osg*/src/core/*" "${ROOT}/tests/core/*"
    "${ROOT}/tests/osg/*")
list(PREPEND includeFolders . apps apps/trainer tests/support data data/generator bench)

# The file of the tree, relative to ROOT, that an include line of `includer` names; nothing for another file. Looks beside
# the including file, then in the include folders.
function(includedFile includer target out)
    set(${out} "" PARENT_SCOPE)
    cmake_path(GET includer PARENT_PATH folder)
    string(REGEX MATCH "^[^/]+" component "${target}")
    list(TRANSFORM includeFolders APPEND "/${target}" OUTPUT_VARIABLE others)
    foreach(candidate "${folder}/${target}" "${component}/include/${target}" ${others})
        cmake_path(NORMAL_PATH candidate)
        if(EXISTS "${ROOT}/${candidate}" AND NOT IS_DIRECTORY "${ROOT}/${candidate}")
            set(${out} "${candidate}" PARENT_SCOPE)
            return()
        endif()
    endforeach()
endfunction()
