// SPDX-License-Identifier: Apache-2.0
// Uses the terrain core in a program without a scene graph: refines a bumpy field to half a metre.
#include <cmath>
#include <cstdio>
#include <memory>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

using namespace osgTerrainROAM::core;

int main()
{
    HeightField field;
    field.name = "bumps";
    field.columns = field.rows = 65;
    field.spacingEastM = field.spacingNorthM = 10.0;
    for (int row = 0; row < field.rows; ++row)
        for (int column = 0; column < field.columns; ++column)
            field.heightsM.push_back(20.0f * std::sin(0.2f * column) * std::sin(0.3f * row));

    RoamMesh mesh(std::make_shared<const RoamTile>(PlacedTile(std::move(field), Placement::planar)));
    const RefineResult result = mesh.refine(0.5);
    std::printf("%u triangles\n", result.triangles);
    return result.triangles > 2 && result.triangles < 2 * 64 * 64 && mesh.isConforming() ? 0 : 1;
}
