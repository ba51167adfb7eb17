# SPDX-License-Identifier: Apache-2.0
# MODE=install: installs the tree built in BUILD to PREFIX. MODE=build: configures SOURCE, a project outside the tree,
# against PREFIX in SCRATCH, with the cache entries in SETTINGS, and builds it. MODE=run: runs the command in RUN in the
# folder SCRATCH. MODE=refuse: the configuring must fail.
cmake_minimum_required(VERSION 3.25)

function(run what)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(failed)
        message(FATAL_ERROR "${what}: ${failed}\n${said}")
    endif()
    message(STATUS "${what}\n${said}")
endfunction()

if(MODE STREQUAL "install")
    file(REMOVE_RECURSE ${PREFIX})
    run("install" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX})
    return()
endif()
if(MODE STREQUAL "run")
    set(ENV{PREFIX} ${PREFIX})
    # A window of a fixed size: OSG's full-screen default is resized after it is made, and Mesa 22.3 overruns a buffer of
    # no size when the context is made in between (seen in 1 of 20 runs under load, none of 120 with this).
    set(ENV{OSG_WINDOW} "0 0 640 480")
    run("run" ${CMAKE_COMMAND} -E chdir ${SCRATCH} ${RUN})
    return()
endif()

file(REMOVE_RECURSE ${SCRATCH})
# Debug compiles in less time; what these programs show of the libraries is the same.
set(configure ${CMAKE_COMMAND} -S ${SOURCE} -B ${SCRATCH} -G Ninja -DCMAKE_BUILD_TYPE=Debug
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${PREFIX} ${SETTINGS})
if(MODE STREQUAL "refuse")
    execute_process(COMMAND ${configure} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT failed OR NOT said MATCHES "no-such-component")
        message(FATAL_ERROR "a component that does not exist was accepted:\n${said}")
    endif()
    return()
endif()
run("configure" ${configure})
run("build" ${CMAKE_COMMAND} --build ${SCRATCH})
