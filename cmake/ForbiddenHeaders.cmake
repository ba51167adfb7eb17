# SPDX-License-Identifier: Apache-2.0
# OSGTRAINER_FORBIDDEN_HEADERS: a folder of the build tree with a header that ends the compilation for each header of
# OSG, OpenGL, EGL, GLX and X11 that this machine has. The cores are compiled with it in front of the system's.
set(OSGTRAINER_FORBIDDEN_HEADERS ${PROJECT_BINARY_DIR}/forbidden-headers)
set(stamp ${OSGTRAINER_FORBIDDEN_HEADERS}/complete)
if(NOT EXISTS ${stamp})
    foreach(root /usr/include /usr/include/${CMAKE_LIBRARY_ARCHITECTURE})
        file(GLOB_RECURSE headers LIST_DIRECTORIES false RELATIVE ${root} ${root}/osg*/* ${root}/OpenThreads/* ${root}/GL/*
            ${root}/GLES*/* ${root}/EGL/* ${root}/KHR/* ${root}/X11/*)
        foreach(header IN LISTS headers)
            file(WRITE ${OSGTRAINER_FORBIDDEN_HEADERS}/${header} "#error \"a core includes <${header}>\"\n")
        endforeach()
    endforeach()
    file(WRITE ${stamp} "")
endif()
