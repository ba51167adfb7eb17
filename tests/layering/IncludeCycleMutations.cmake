# SPDX-License-Identifier: Apache-2.0
# Proves that the check of include cycles can fail: a small tree without cycles passes; with one include line more, which
# closes a cycle, it does not.
cmake_minimum_required(VERSION 3.25)

function(plantTree)
    file(REMOVE_RECURSE "${SCRATCH}")
    foreach(entry
            "viewlod/include/viewlod/Frustum.h|array"
            "viewlod/include/viewlod/ViewState.h|viewlod/Frustum.h"
            "osgTerrainROAM/include/osgTerrainROAM/core/heightfield/Tile.h|viewlod/Frustum.h"
            "osgTerrainROAM/include/osgTerrainROAM/core/roam/Mesh.h|osgTerrainROAM/core/heightfield/Tile.h"
            "osgTerrainROAM/include/osgTerrainROAM/core/edit/Editor.h|osgTerrainROAM/core/roam/Mesh.h"
            "osgTerrainROAM/include/osgTerrainROAM/Terrain|osgTerrainROAM/core/edit/Editor.h"
            "osgTerrainROAM/src/core/heightfield/Tile.cpp|osgTerrainROAM/core/heightfield/Tile.h"
            "osgTerrainROAM/src/core/roam/Mesh.cpp|osgTerrainROAM/core/roam/Mesh.h"
            "osgTerrainROAM/src/view/Group.h|osgTerrainROAM/core/roam/Mesh.h"
            "osgTerrainROAM/src/view/Table.h|osgTerrainROAM/core/roam/Mesh.h"
            "simulation/state/State.h|array"
            "simulation/vehicle/Car.cpp|../state/State.h"
            "simulation/player/actions/Brake.cpp|../Player.h"
            "simulation/player/Player.h|../state/State.h"
            "scenery/models/houses/House.h|../mesh/Box.h"
            "scenery/models/mesh/Box.h|array"
            "apps/trainer/window/Window.cpp|../../../simulation/player/Player.h"
            "osgPMObjects/src/core/mesh/Mesh.cpp|array"
            "osgPMObjects/include/osgPMObjects/core/edit/Order.h|array")
        string(REPLACE "|" ";" entry "${entry}")
        list(GET entry 0 file)
        list(GET entry 1 include)
        file(WRITE "${SCRATCH}/${file}" "#pragma once\n#include <${include}>\n")
    endforeach()
    file(APPEND "${SCRATCH}/osgTerrainROAM/src/view/Table.h" "#include \"Group.h\"\n")
endfunction()

# Runs the check over the scratch tree; `expected` is pass, or what the complaint must say.
function(expect expected case)
    execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${SCRATCH} -P ${CHECK}
        RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
    string(REGEX REPLACE "[ \n]+" " " said "${said}")
    if(expected STREQUAL "pass")
        if(failed)
            message(SEND_ERROR "${case}: a tree without a cycle was refused: ${said}")
        endif()
        return()
    endif()
    string(FIND "${said}" "${expected}" position)
    if(NOT failed OR position EQUAL -1)
        message(SEND_ERROR "${case}: passed, or failed without '${expected}': ${said}")
    endif()
endfunction()

# One include line more in one file of the tree must be refused with `expected`.
function(expectCycle file line expected)
    plantTree()
    file(APPEND "${SCRATCH}/${file}" "${line}\n")
    expect("${expected}" "${file} with ${line}")
endfunction()

plantTree()
expect(pass "the clean tree")
file(APPEND "${SCRATCH}/osgPMObjects/src/core/mesh/Mesh.cpp" "#include <osgPMObjects/core/edit/Order.h>\n")
expect(pass "folders of one name in two cores")
file(APPEND "${SCRATCH}/simulation/player/Player.h" "#include \"actions/Order.h\"\n")
file(WRITE "${SCRATCH}/simulation/player/actions/Order.h" "#include <array>\n")
expect(pass "a folder and one within it")

set(roam osgTerrainROAM/include/osgTerrainROAM/core/roam/Mesh.h)
expectCycle(osgTerrainROAM/src/core/roam/Mesh.cpp "#include <osgTerrainROAM/core/edit/Editor.h>"
    "osgTerrainROAM_core/roam includes osgTerrainROAM_core/edit (osgTerrainROAM/src/core/roam/Mesh.cpp)")
expectCycle(osgTerrainROAM/src/core/heightfield/Tile.cpp "#include <osgTerrainROAM/core/edit/Editor.h>"
    "osgTerrainROAM_core/heightfield includes osgTerrainROAM_core/edit")
expectCycle(osgTerrainROAM/src/core/heightfield/Tile.cpp "#include \"../../../include/osgTerrainROAM/core/edit/Editor.h\""
    "osgTerrainROAM_core/edit includes osgTerrainROAM_core/roam")
expectCycle(simulation/state/State.h "#include \"../vehicle/Car.cpp\"" "simulation/state includes simulation/vehicle")
expectCycle(scenery/models/mesh/Box.h "#include \"../houses/House.h\"" "scenery/models/houses includes scenery/models/mesh")
expectCycle(simulation/state/State.h "#include \"../../apps/trainer/window/Window.cpp\"" "apps includes simulation")
expectCycle(viewlod/include/viewlod/Frustum.h "#include <viewlod/ViewState.h>"
    "headers: viewlod/include/viewlod/")
expectCycle(${roam} "#include <osgTerrainROAM/Terrain>" "${roam} includes osgTerrainROAM/include/osgTerrainROAM/Terrain")
expectCycle(osgTerrainROAM/src/view/Group.h "  #  include \"Table.h\" // one day"
    "osgTerrainROAM/src/view/Group.h includes osgTerrainROAM/src/view/Table.h")
expectCycle(osgTerrainROAM/src/view/Group.h "#include \"Group.h\""
    "osgTerrainROAM/src/view/Group.h includes osgTerrainROAM/src/view/Group.h")

file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
expect("no include line was read" "an empty tree")
file(REMOVE_RECURSE "${SCRATCH}")
expect("names no folder" "a folder that is not there")
