// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/houses/RoofFittings.h"

#include <algorithm>
#include <cmath>

#include "scenery/models/houses/DetailAtlas.h"
#include "scenery/models/mesh/Box.h"
#include "scenery/models/mesh/Tube.h"

namespace scenery::models
{

namespace
{

} // namespace

void addChimney(ModelBuilder& builder, const HouseShell& shell, const glm::dvec2& place, double aboveRidgeM)
{
    const glm::dvec3 at = shell.middle + glm::dvec3(place, 0.0);
    const double top = shell.roof.base.z + shell.roof.topAt(0.0) + aboveRidgeM;
    const double foot = shell.roof.base.z + shell.roof.topAt(std::abs(place.y) + 0.35) - 0.5;
    builder.begin("chimney", kHouseDetails);
    const CellUv brick = uvOf(Detail::bricks);
    const CellUv stone = uvOf(Detail::stone);
    addBox(builder, {{at.x - 0.42, at.y - 0.28, foot},
                     {at.x + 0.42, at.y + 0.28, top},
                     brick.at(0.0F, 0.0F),
                     brick.at(0.6F, 1.0F)});
    addBox(builder, {{at.x - 0.50, at.y - 0.36, top - 0.02},
                     {at.x + 0.50, at.y + 0.36, top + 0.10},
                     stone.at(0.0F, 0.4F),
                     stone.at(1.0F, 0.5F)});
    for (const double pot : {-0.2, 0.2})
        addBar(builder, at * glm::dvec3(1, 1, 0) + glm::dvec3(pot, 0, top + 0.05),
               at * glm::dvec3(1, 1, 0) + glm::dvec3(pot, 0, top + 0.42), 0.11, 8, brick.at(0.5F, 0.52F));
}

void addGableWindows(ModelBuilder& builder, const HouseShell& shell)
{
    builder.begin("gable windows", kHouseDetails, shell.frameTint);
    const CellUv uv = uvOf(Detail::window);
    const double z = shell.rows.back() + 0.45;
    for (const double side : {-1.0, 1.0})
    {
        const double x = shell.middle.x + side * 0.5 * shell.lengthM;
        addBox(builder, {{std::min(x - 0.1 * side, x + 0.04 * side), shell.middle.y - 0.5, z},
                         {std::max(x - 0.1 * side, x + 0.04 * side), shell.middle.y + 0.5, z + 1.15},
                         uv.low,
                         uv.high,
                         1.0F});
    }
}

void addDormer(ModelBuilder& builder, const HouseShell& shell, double atX, double insideM)
{
    constexpr double kHalfM = 0.85;
    constexpr double kHighM = 1.45;
    const double slope = shell.roof.slope;
    const double across = 0.5 * shell.widthM - insideM; // from the ridge
    const double foot = shell.roof.base.z + shell.roof.topAt(across);
    const double top = foot + kHighM;
    const glm::dvec3 front = shell.middle * glm::dvec3(1, 1, 0) + glm::dvec3(atX, -across, 0.0);
    Wall wall;
    wall.start = front - glm::dvec3(kHalfM, 0, 0);
    wall.lengthM = 2.0 * kHalfM;
    wall.rows = {foot - 0.25, foot + 0.12, foot + 1.30, top};
    wall.openings = {{0.25, 2.0 * kHalfM - 0.25, foot + 0.12, foot + 1.30, Detail::window, 0.08, false}};
    wall.hasGable = true;
    wall.gableM = 0.75 * kHalfM;
    builder.begin("dormer", shell.wallSurface, shell.wallTint);
    addWallFace(builder, wall);
    const double run = kHighM / slope; // in which the roof rises to the dormer's eaves
    for (const double side : {-1.0, 1.0})
    {
        const auto at = [&](double inM, double z)
        {
            return Corner{front + glm::dvec3(side * kHalfM, inM, z),
                          {static_cast<float>(inM / kWallPictureM), static_cast<float>(z / kWallPictureM)}};
        };
        const Corner back = at(run + 0.3, top);
        for (std::size_t r = 0; r + 1 < wall.rows.size(); ++r) // cut at the heights of the front
        {
            const Corner low = at(0.0, wall.rows[r]);
            const Corner high = at(0.0, wall.rows[r + 1]);
            if (side < 0.0)
                builder.triangle(low, high, back);
            else
                builder.triangle(high, low, back);
        }
    }
    builder.begin("dormer window", kHouseDetails, shell.frameTint);
    addOpenings(builder, wall, false);
    GableRoof roof;
    roof.base = front + glm::dvec3(0, 0, top);
    roof.axis = {0.0, -1.0, 0.0};
    roof.from = -(run + (0.75 * kHalfM + 0.1) / slope + 0.15);
    roof.to = 0.22;
    roof.halfWidth = kHalfM;
    roof.overhang = 0.16;
    roof.slope = 0.75;
    roof.thickness = 0.10;
    addGableRoof(builder, roof, shell.roofSurface, shell.roofTint, false);
}

} // namespace scenery::models
