// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/houses/Hall.h"

#include <cmath>

#include "scenery/models/Dice.h"
#include "scenery/models/houses/DetailAtlas.h"
#include "scenery/models/houses/HouseColours.h"
#include "scenery/models/houses/HouseShell.h"
#include "scenery/models/mesh/Box.h"

namespace scenery::models
{

namespace
{

void addBand(Wall& wall, int count, double shareWide, double bottomM, double topM)
{
    const double pitch = wall.lengthM / count;
    for (int i = 0; i < count; ++i)
        wall.openings.push_back({(i + 0.5 - 0.5 * shareWide) * pitch, (i + 0.5 + 0.5 * shareWide) * pitch,
                                 bottomM, topM, Detail::hallWindow, 0.08, false});
}

/// Adds skylights, slabs of frosted plastic, on both slopes of the roof.
void addSkylights(ModelBuilder& builder, const HouseShell& shell, int count)
{
    builder.begin("skylight", kHouseDetails);
    const CellUv uv = uvOf(Detail::skylight);
    const GableRoof& roof = shell.roof;
    const double pitch = shell.lengthM / count;
    for (int i = 0; i < count; ++i)
        for (const double side : {-1.0, 1.0})
        {
            const double x = -0.5 * shell.lengthM + (i + 0.5) * pitch;
            const auto cornerAt = [&](std::size_t end, std::size_t point, std::size_t)
            {
                // Points seen against +x: 0 top of the lower edge, 1 top of the upper edge, 2 and 3 the
                // bottoms of both.
                const bool isUpper = point == 1 || point == 2;
                const double across = (isUpper ? 0.30 : 0.72) * roof.halfWidth;
                const double lift = point <= 1 ? 0.06 : -0.05;
                return Corner{
                    {x + (end == 1 ? 0.7 : -0.7), side * across, roof.base.z + roof.topAt(across) + lift},
                    uv.at(end == 1 ? 1.0F : 0.0F, isUpper ? 1.0F : 0.0F)};
            };
            const auto mirrored = [&](std::size_t end, std::size_t point, std::size_t face)
            { return cornerAt(end, 3 - point, face); };
            if (side > 0.0)
                addPrism(builder, 4, cornerAt);
            else
                addPrism(builder, 4, mirrored);
        }
}

} // namespace

Model makeBarn(std::uint64_t seed)
{
    Dice dice(seed + 40000);
    HouseShell shell;
    shell.lengthM = dice.between(14.0, 20.0);
    shell.widthM = dice.between(9.0, 12.0);
    const double eaves = dice.between(3.9, 4.8);
    const double head = 3.45;
    shell.rows = {kPlinthM - 0.05, kPlinthM, 1.5, 2.4, head, eaves};
    shell.wallSurface = {Painting::planks, Coat::matt};
    shell.roofSurface = {Painting::roofTiles, Coat::matt};
    shell.wallTint = dice.chance(0.35) ? glm::vec3(0.78F, 0.32F, 0.25F)
                                       : glm::vec3(1.0F) * static_cast<float>(dice.between(0.75, 1.0));
    shell.roofTint = dice.oneOf(kTileTints);
    shell.doorTint = shell.wallTint * 0.85F;
    shell.hasGutters = dice.chance(0.5);
    setUpShell(shell, dice.between(0.75, 1.0), 0.6, 0.5);
    const double doorAt = shell.lengthM * dice.between(0.3, 0.55);
    shell.walls[0].openings = {
        {doorAt - 1.7, doorAt + 1.7, kPlinthM, head, Detail::barnDoor, 0.06, false},
        {1.5, 2.3, 1.5, 2.4, Detail::barsWindow, 0.08},
        {shell.lengthM - 2.6, shell.lengthM - 1.8, 1.5, 2.4, Detail::barsWindow, 0.08}};
    const double middle = 0.5 * shell.widthM;
    shell.walls[1].openings = {{middle - 1.6, middle + 1.6, kPlinthM, head, Detail::barnDoor, 0.06, false}};
    for (int i = 0; i < 4; ++i)
    {
        const double at = shell.lengthM * (i + 0.5) / 4;
        shell.walls[2].openings.push_back({at - 0.4, at + 0.4, 1.5, 2.4, Detail::barsWindow, 0.08});
    }
    ModelBuilder builder;
    addShell(builder, shell);
    return builder.finish();
}

Model makeHall(std::uint64_t seed)
{
    Dice dice(seed + 50000);
    HouseShell shell;
    const int bays = 5 + dice.below(3);
    shell.lengthM = bays * dice.between(5.2, 6.0);
    shell.widthM = dice.between(15.0, 22.0);
    const double eaves = dice.between(5.8, 8.0);
    const double gate = 4.2;
    shell.rows = {kPlinthM - 0.05, kPlinthM, 2.45, gate, eaves - 1.3, eaves - 0.5, eaves};
    shell.wallSurface = {Painting::sheetMetal, Coat::matt};
    shell.roofSurface = {Painting::roofMetal, Coat::matt};
    shell.wallTint = dice.oneOf(kSheetTints);
    shell.roofTint = glm::vec3(0.85F) * static_cast<float>(dice.between(0.8, 1.05));
    shell.doorTint = dice.oneOf(
        std::array{glm::vec3(0.85F), glm::vec3(0.30F, 0.42F, 0.60F), glm::vec3(0.65F, 0.22F, 0.18F)});
    setUpShell(shell, dice.between(0.17, 0.26), 0.25, 0.2);
    shell.roof.thickness = 0.25;
    addBand(shell.walls[0], bays, 0.8, eaves - 1.3, eaves - 0.5);
    addBand(shell.walls[2], bays, 0.8, eaves - 1.3, eaves - 0.5);
    const double pitch = shell.lengthM / bays;
    const int firstGate = dice.below(2);
    for (int bay = firstGate; bay < bays; bay += 2)
        shell.walls[0].openings.push_back({(bay + 0.5) * pitch - 1.9, (bay + 0.5) * pitch + 1.9, kPlinthM,
                                           gate, Detail::gate, 0.12, false});
    const double door = (firstGate == 0 ? 1.5 : 0.5) * pitch;
    shell.walls[0].openings.push_back({door - 0.5, door + 0.5, kPlinthM, 2.45, Detail::door, 0.1, false});
    const double middle = 0.5 * shell.widthM;
    shell.walls[1].openings = {{middle - 2.2, middle + 2.2, kPlinthM, gate, Detail::gate, 0.12, false}};
    ModelBuilder builder;
    addShell(builder, shell);
    addSkylights(builder, shell, bays);
    builder.begin("ventilator", kHouseDetails);
    const double ridge = shell.roof.base.z + shell.roof.topAt(0.0);
    const CellUv zinc = uvOf(Detail::zinc);
    addBox(builder, {{-0.3 * shell.lengthM, -0.5, ridge - 0.35},
                     {0.3 * shell.lengthM, 0.5, ridge + 0.45},
                     zinc.at(0, 0),
                     zinc.at(1, 1)});
    return builder.finish();
}

} // namespace scenery::models
