# SPDX-License-Identifier: Apache-2.0
# Proves that the layering check can fail: a small tree that keeps the arrows passes, the same tree with one include
# line more does not, nor does an empty one.
cmake_minimum_required(VERSION 3.25)

function(plantTree)
    file(REMOVE_RECURSE "${SCRATCH}")
    foreach(entry
            "foundation/include/foundation/Result.h|variant"
            "viewlod/include/viewlod/Frustum.h|array"
            "osgTerrainROAM/include/osgTerrainROAM/core/Tile.h|viewlod/Frustum.h"
            "osgTerrainROAM/src/core/Tile.cpp|osgTerrainROAM/core/Tile.h"
            "osgTerrainROAM/include/osgTerrainROAM/Terrain|osgTerrainROAM/core/Tile.h"
            "osgTerrainROAM/src/Terrain.cpp|osg/Drawable"
            "osgTerrainROAM/src/Cull.cpp|osgTraversal/CullFacts"
            "osgTraversal/include/osgTraversal/CullFacts|osg/Camera"
            "osgTraversal/src/CullFacts.cpp|viewlod/Frustum.h"
            "osgSky/include/osgSky/Atmosphere|osg/Light"
            "osgSky/src/SunShadows.cpp|osgTraversal/CullFacts"
            "osgPMObjects/include/osgPMObjects/core/Mesh.h|viewlod/Frustum.h"
            "osgPMObjects/include/osgPMObjects/Object|osg/Drawable"
            "osgRoads/include/osgRoads/core/Road.h|foundation/Result.h"
            "osgMultiTriangulation/include/osgMultiTriangulation/core/Forest.h|osgPMObjects/core/Mesh.h"
            "osgRoads/include/osgRoads/RoadDrawable|osg/Drawable"
            "osgMultiTriangulation/include/osgMultiTriangulation/MtDrawable|osgTerrainROAM/RoamTerrain"
            "osgPMObjects/src/Object.cpp|osgTraversal/CullFacts"
            "osgOffscreen/include/osgOffscreen/Capture|osg/Image"
            "simulation/Clock.h|cstdint"
            "simulation/contact/Obstacle.h|cstdint"
            "scenery/json/Fields.h|foundation/Result.h"
            "scenery/lights/Beam.h|foundation/Result.h"
            "scenery/models/Tree.h|osgPMObjects/core/Mesh.h"
            "scenery/placement/Place.h|scenery/models/Tree.h"
            "scenery/clouds/Cloud.h|foundation/Result.h"
            "worldmaking/streets/Heights.h|scenery/roads/CutRoads.h"
            "scenery/buildings/House.h|scenery/models/Tree.h"
            "scenery/roads/CutRoads.h|osgRoads/core/place/PlacedNetwork.h"
            "scenery/roads/things/Things.h|scenery/models/Tree.h"
            "scenery/nodes/Sky.h|osgTerrainROAM/Terrain"
            "measurement/Flight.h|osgTerrainROAM/core/Tile.h"
            "measurement/view/Sheet.h|osgOffscreen/Capture"
            "measurement/light/Lamps.h|scenery/lights/Beam.h"
            "measurement/light/view/Pictures.h|scenery/nodes/Sky.h"
            "apps/terminal/Terminal.h|foundation/Result.h"
            "scenery/ground/Ground.h|osgTerrainROAM/core/Tile.h"
            "apps/pmtool/polygons/Polygons.h|array"
            "apps/trainer/input/Keys.h|simulation/Clock.h"
            "osgSession/src/core/Steps.h|simulation/Clock.h"
            "osgSession/view/Scene.cpp|osgTerrainROAM/Terrain"
            "apps/trainer/hud/Hud.cpp|osgTerrainROAM/Terrain"
            "apps/terraintool/main.cpp|osgTerrainROAM/core/Tile.h"
            "bench/Frames.cpp|osgTerrainROAM/Terrain"
            "bench/compare/Tables.cpp|Frames.cpp"
            "examples/planes/main.cpp|osgTerrainROAM/Terrain"
            "cmake/Suppressions.cpp|cstdint"
            "data/generator/Noise.h|cmath"
            "tests/support/Random.h|cstdint"
            "tests/support/RenderedView.h|osgOffscreen/Capture"
            "tests/core/tile/TileTest.cpp|osgTerrainROAM/core/Tile.h"
            "tests/fuzz/KeptSceneFuzzer.cpp|osgTerrainROAM/Terrain"
            "tests/install/core/main.cpp|viewlod/Frustum.h"
            "tests/osg/terrain/TerrainTest.cpp|osgTerrainROAM/Terrain"
            "tests/osg/shaders/LookTest.cpp|bench/frames/Look.h"
            "tests/render/terrain/GoldenTest.cpp|osgOffscreen/Capture"
            "tests/tree/weights/Weights.h|foundation/Result.h"
            "tests/programs/PlayTest.cpp|foundation/Result.h")
        string(REPLACE "|" ";" entry "${entry}")
        list(GET entry 0 file)
        list(GET entry 1 include)
        file(WRITE "${SCRATCH}/${file}" "#pragma once\n#include <${include}>\n")
    endforeach()
endfunction()

# Runs the check over the scratch tree; `expected` is pass, or what the complaint must say.
function(expect expected case)
    execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${SCRATCH} -P ${CHECK}
        RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
    string(REGEX REPLACE "[ \n]+" " " said "${said}")
    if(expected STREQUAL "pass")
        if(failed)
            message(SEND_ERROR "${case}: a tree without a breach was refused: ${said}")
        endif()
    elseif(NOT failed)
        message(SEND_ERROR "${case}: passed")
    else()
        string(FIND "${said}" "${expected}" place)
        if(place EQUAL -1)
            message(SEND_ERROR "${case}: failed, but without '${expected}': ${said}")
        endif()
    endif()
endfunction()

# One include line more in one file of the tree must be refused, by the file's name.
function(expectBreach file line)
    plantTree()
    file(APPEND "${SCRATCH}/${file}" "${line}\n")
    expect("${file}: " "${file} with ${line}")
endfunction()

plantTree()
expect(pass "the clean tree")

expectBreach(foundation/include/foundation/Result.h "#include <viewlod/Frustum.h>")
expectBreach(viewlod/include/viewlod/Frustum.h "#include <osg/Matrixd>")
expectBreach(viewlod/include/viewlod/Frustum.h "#include <osgTerrainROAM/core/Tile.h>")
expectBreach(viewlod/include/viewlod/Frustum.h "#include <osgTerrainROAM/core/NotThere.h>")
expectBreach(osgTerrainROAM/src/core/Tile.cpp "#include <osg/Vec3d>")
expectBreach(osgTerrainROAM/src/core/Tile.cpp "  #  include <GL/gl.h>")
expectBreach(osgTerrainROAM/src/core/Tile.cpp "#include <EGL/egl.h>")
expectBreach(osgTerrainROAM/src/core/Tile.cpp "#include <OpenThreads/Mutex>")
expectBreach(osgTerrainROAM/src/core/Tile.cpp "#include <osgTerrainROAM/Terrain>")
expectBreach(osgTerrainROAM/src/core/Tile.cpp "#include \"../../include/osgTerrainROAM/Terrain\"")
expectBreach(osgTerrainROAM/include/osgTerrainROAM/core/Tile.h "#include <osgViewer/Viewer> // one day")
expectBreach(osgPMObjects/include/osgPMObjects/core/Mesh.h "#include <osgTerrainROAM/core/Tile.h>")
expectBreach(osgPMObjects/include/osgPMObjects/Object "#include <osgTerrainROAM/Terrain>")
expectBreach(osgOffscreen/include/osgOffscreen/Capture "#include <osgTerrainROAM/Terrain>")
expectBreach(osgRoads/include/osgRoads/core/Road.h "#include <osg/Vec3d>")
expectBreach(osgRoads/include/osgRoads/core/Road.h "#include <osgTerrainROAM/core/Tile.h>")
expectBreach(osgMultiTriangulation/include/osgMultiTriangulation/core/Forest.h "#include <osg/Vec3d>")
expectBreach(osgMultiTriangulation/include/osgMultiTriangulation/core/Forest.h "#include <osgTerrainROAM/core/Tile.h>")
expectBreach(osgTerrainROAM/src/core/Tile.cpp "#include <osgRoads/core/NotThere.h>")
expectBreach(osgTerrainROAM/src/Terrain.cpp "#include <osgOffscreen/Capture>")
expectBreach(osgTerrainROAM/src/Terrain.cpp "#include <osgMultiTriangulation/MtDrawable>")
expectBreach(osgTraversal/include/osgTraversal/CullFacts "#include <osgPMObjects/Object>")
expectBreach(osgTraversal/include/osgTraversal/CullFacts "#include <osgPMObjects/core/Mesh.h>")
expectBreach(osgTraversal/src/CullFacts.cpp "#include <osgTerrainROAM/Terrain>")
expectBreach(osgSky/src/SunShadows.cpp "#include <osgTerrainROAM/Terrain>")
expectBreach(osgTraversal/src/CullFacts.cpp "#include <osgSky/Atmosphere>")
expectBreach(osgOffscreen/include/osgOffscreen/Capture "#include <osgTraversal/CullFacts>")
expectBreach(osgPMObjects/include/osgPMObjects/core/Mesh.h "#include <osgTraversal/CullFacts>")
expectBreach(osgTerrainROAM/src/core/Tile.cpp "#include <osgTraversal/NotThere>")
expectBreach(simulation/Clock.h "#include <osg/Timer>")
expectBreach(simulation/contact/Obstacle.h "#include \"simulation/Clock.h\"")
expectBreach(scenery/lights/Beam.h "#include \"scenery/models/Tree.h\"")
expectBreach(scenery/json/Fields.h "#include \"scenery/models/Tree.h\"")
expectBreach(simulation/Clock.h "#include \"../osgSession/view/Scene.cpp\"")
expectBreach(scenery/models/Tree.h "#include <osg/Image>")
expectBreach(scenery/models/Tree.h "#include <osgPMObjects/Object>")
expectBreach(scenery/placement/Place.h "#include <osg/Matrixd>")
expectBreach(scenery/placement/Place.h "#include \"../../simulation/Clock.h\"")
expectBreach(apps/terraintool/main.cpp "#include \"../trainer/view/Scene.cpp\"")
expectBreach(apps/terraintool/main.cpp "#include \"../../bench/Frames.cpp\"")
expectBreach(apps/terraintool/main.cpp "#include \"Frames.cpp\"")
expectBreach(osgSession/view/Scene.cpp "#include \"terraintool/main.cpp\"")
expectBreach(apps/terminal/Terminal.h "#include \"simulation/Clock.h\"")
expectBreach(apps/pmtool/polygons/Polygons.h "#include <osg/Node>")
expectBreach(measurement/Flight.h "#include <osg/Vec3d>")
expectBreach(measurement/Flight.h "#include \"measurement/view/Sheet.h\"")
expectBreach(measurement/view/Sheet.h "#include \"scenery/nodes/Sky.h\"")
expectBreach(measurement/light/Lamps.h "#include \"scenery/nodes/Sky.h\"")
expectBreach(measurement/light/view/Pictures.h "#include \"../../../osgSession/view/Scene.cpp\"")
expectBreach(scenery/nodes/Sky.h "#include \"view/Scene.cpp\"")
expectBreach(scenery/nodes/Sky.h "#include \"measurement/Flight.h\"")
expectBreach(scenery/nodes/Sky.h "#include <osgOffscreen/Capture>")
expectBreach(bench/Frames.cpp "#include \"view/Scene.cpp\"")
expectBreach(bench/Frames.cpp "#include \"terraintool/main.cpp\"")
expectBreach(bench/Frames.cpp "#include \"compare/Tables.cpp\"")
expectBreach(bench/compare/Tables.cpp "#include \"view/Scene.cpp\"")
expectBreach(bench/Frames.cpp "#include \"../tests/core/tile/TileTest.cpp\"")
expectBreach(examples/planes/main.cpp "#include \"scenery/nodes/Sky.h\"")
expectBreach(examples/planes/main.cpp "#include \"measurement/Flight.h\"")
expectBreach(examples/planes/main.cpp "#include <osgTraversal/CullFacts>")
expectBreach(data/generator/Noise.h "#include <osgTerrainROAM/core/Tile.h>")
expectBreach(tests/support/Random.h "#include <osg/Vec3d>")
expectBreach(tests/support/Random.h "#include \"RenderedView.h\"")
expectBreach(tests/support/RenderedView.h "#include \"view/Scene.cpp\"")
expectBreach(tests/core/tile/TileTest.cpp "#include \"RenderedView.h\"")
expectBreach(tests/core/tile/TileTest.cpp "#include \"TerrainTest.cpp\"")
expectBreach(tests/fuzz/KeptSceneFuzzer.cpp "#include \"Frames.cpp\"")
expectBreach(tests/install/core/main.cpp "#include \"Random.h\"")
expectBreach(tests/osg/terrain/TerrainTest.cpp "#include \"Frames.cpp\"")
expectBreach(tests/render/terrain/GoldenTest.cpp "#include \"../../../bench/Frames.cpp\"")
expectBreach(tests/render/terrain/GoldenTest.cpp "#include \"../../../examples/planes/main.cpp\"")
expectBreach(tests/programs/PlayTest.cpp "#include \"view/Scene.cpp\"")
expectBreach(tests/programs/PlayTest.cpp "#include \"Frames.cpp\"")
expectBreach(tests/programs/PlayTest.cpp "#include \"TerrainTest.cpp\"")
expectBreach(osgTerrainROAM/src/Terrain.cpp "#include \"NotThere.h\"")
expectBreach(tests/core/tile/TileTest.cpp "#include <osgDB/ReadFile>")

plantTree()
file(WRITE "${SCRATCH}/sound/Horn.cpp" "#include <cmath>\n")
expect("sound/Horn.cpp: belongs to no layer" "a folder that no layer names")
plantTree()
file(REMOVE_RECURSE "${SCRATCH}/osgTerrainROAM/src/core" "${SCRATCH}/osgTerrainROAM/include/osgTerrainROAM/core")
expect("terrain-core: no file matches" "a tree without its terrain core")
plantTree()
file(REMOVE_RECURSE "${SCRATCH}/osgTraversal")
expect("traversal: no file matches" "a tree without what its libraries share")
foreach(folder bench examples tests/osg tests/render tests/programs)
    plantTree()
    file(REMOVE_RECURSE "${SCRATCH}/${folder}")
    expect(": no file matches ^" "a tree without ${folder}")
endforeach()
file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
expect("no include line was read" "an empty tree")
file(REMOVE_RECURSE "${SCRATCH}")
expect("names no folder" "a folder that is not there")
