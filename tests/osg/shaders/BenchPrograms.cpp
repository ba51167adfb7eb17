// SPDX-License-Identifier: Apache-2.0
#include <frames/Look.h>
#include <objects/VertexLights.h>

#include "Compositions.h"
#include "SyntheticField.h"

namespace shadercheck
{

std::vector<NamedProgram> benchPrograms()
{
    const auto ofState = [](const osg::StateSet& state)
    { return dynamic_cast<const osg::Program*>(state.getAttribute(osg::StateAttribute::PROGRAM)); };
    const auto tile = testsupport::planarTile(testsupport::hills(9, 9));
    const osg::ref_ptr<osgTerrainROAM::TerrainMaterial> material =
        new osgTerrainROAM::TerrainMaterial(tile->tile, osgTerrainROAM::Climate());
    std::vector<NamedProgram> programs;
    for (const framebench::Look look :
         {framebench::Look::full, framebench::Look::relief, framebench::Look::distance})
    {
        const std::string name = "frame_bench " + std::string(framebench::lookName(look));
        programs.push_back({name, ofState(*framebench::lookState(*material, look))});
        programs.push_back({name + ", plain vertices", framebench::plainVertexProgram(*material, look)});
    }
    const osg::BoundingSphere ball(osg::Vec3(), 1.0f);
    for (const int lamps : {1, 8})
        programs.push_back({"object_frame_bench, lamps: " + std::to_string(lamps),
                            ofState(*objectbench::vertexLights(lamps, ball))});
    return programs;
}

} // namespace shadercheck
