// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/houses/HouseShell.h"

#include "scenery/models/houses/DetailAtlas.h"
#include "scenery/models/mesh/Box.h"
#include "scenery/models/mesh/Tube.h"

namespace scenery::models
{

namespace
{

void addPlinth(ModelBuilder& builder, const HouseShell& shell)
{
    constexpr double kProudM = 0.03;
    builder.begin("plinth", kHouseDetails, glm::vec3(0.8F));
    const CellUv uv = uvOf(Detail::stone);
    const glm::dvec3 half(0.5 * shell.lengthM + kProudM, 0.5 * shell.widthM + kProudM, 0.0);
    addBox(builder, {shell.middle - half - glm::dvec3(0, 0, kFoundationM),
                     shell.middle + half + glm::dvec3(0, 0, kPlinthM), uv.at(0.0F, 0.1F), uv.at(1.0F, 0.4F)});
}

void addDownpipes(ModelBuilder& builder, const HouseShell& shell)
{
    builder.begin("downpipe", kHouseDetails);
    const glm::vec2 uv = uvOf(Detail::zinc).middle();
    for (const double side : {-1.0, 1.0})
    {
        const glm::dvec3 foot =
            shell.middle + glm::dvec3(-0.5 * shell.lengthM + 0.25, side * (0.5 * shell.widthM + 0.08), 0.05);
        const double out = shell.roof.overhang;
        const double top = shell.rows.back() - out * shell.roof.slope - 0.30;
        const glm::dvec3 bend = foot + glm::dvec3(0, 0, top - 0.05);
        const glm::dvec3 elbow = bend - glm::dvec3(0, 0, 0.15);
        addBar(builder, foot, elbow, 0.045, 6, uv);
        addBar(builder, elbow, bend + glm::dvec3(0, side * (out - 0.02), 0.38), 0.045, 6, uv);
    }
}

} // namespace

void setUpShell(HouseShell& shell, double slope, double eavesM, double vergeM)
{
    const double x = 0.5 * shell.lengthM;
    const double y = 0.5 * shell.widthM;
    const std::array<glm::dvec3, 4> corners{glm::dvec3(-x, -y, 0), {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
    const std::array<glm::dvec3, 4> along{glm::dvec3(1, 0, 0), {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    for (std::size_t i = 0; i < 4; ++i)
    {
        Wall& wall = shell.walls[i];
        wall.start = shell.middle + corners[i];
        wall.along = along[i];
        wall.lengthM = i % 2 == 0 ? shell.lengthM : shell.widthM;
        wall.rows = shell.rows;
        wall.hasGable = i % 2 == 1;
        wall.gableM = slope * y;
    }
    shell.roof.base = shell.middle + glm::dvec3(0, 0, shell.rows.back());
    shell.roof.from = -x - vergeM;
    shell.roof.to = x + vergeM;
    shell.roof.halfWidth = y;
    shell.roof.overhang = eavesM;
    shell.roof.slope = slope;
}

void addShell(ModelBuilder& builder, const HouseShell& shell)
{
    builder.begin("walls", shell.wallSurface, shell.wallTint);
    for (const Wall& wall : shell.walls)
        addWallFace(builder, wall);
    builder.begin("windows", kHouseDetails, shell.frameTint);
    for (const Wall& wall : shell.walls)
        addOpenings(builder, wall, false);
    builder.begin("doors", kHouseDetails, shell.doorTint);
    for (const Wall& wall : shell.walls)
        addOpenings(builder, wall, true);
    builder.begin("sills", kHouseDetails);
    for (const Wall& wall : shell.walls)
        addSills(builder, wall);
    addPlinth(builder, shell);
    addGableRoof(builder, shell.roof, shell.roofSurface, shell.roofTint, shell.hasGutters);
    if (shell.hasGutters) addDownpipes(builder, shell);
}

} // namespace scenery::models
