// SPDX-License-Identifier: Apache-2.0
// Shows a terrain in a viewer of OpenSceneGraph: terrain_in_osgviewer dem.tif | place.roam
#include <cstdio>

#include <osgGA/TerrainManipulator>
#include <osgViewer/Viewer>

#include <osgTerrainROAM/RoamTerrain>

int main(int argc, char** argv)
{
    const auto terrain = osgTerrainROAM::openTerrain(argc > 1 ? argv[1] : "");
    if (!terrain)
    {
        std::fprintf(stderr, "terrain_in_osgviewer: %s\n", terrain.error().message().c_str());
        return 1;
    }
    osgViewer::Viewer viewer;
    viewer.setSceneData(terrain->get());
    viewer.setCameraManipulator(new osgGA::TerrainManipulator);
    if (argc > 2 && std::string(argv[2]) == "--once") // one frame, for the tests
    {
        viewer.frame();
        return 0;
    }
    return viewer.run();
}
