// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/houses/GableHouse.h"

#include <array>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "scenery/models/Dice.h"
#include "scenery/models/houses/HouseColours.h"
#include "scenery/models/houses/HouseShell.h"
#include "scenery/models/houses/RoofFittings.h"
#include "scenery/models/mesh/Box.h"
#include "scenery/models/mesh/Tube.h"

namespace scenery::models
{

namespace
{

constexpr double kGableStoreyM = 2.75;
constexpr double kGableSillM = 0.92;
constexpr double kGableHeadM = 2.30;

/// Adds windows to a wall, `axes` in each storey, evenly spaced. On the ground floor a door replaces window
/// `doorAxis`.
void addAxes(Wall& wall, int storeys, int axes, int doorAxis, Detail window)
{
    const double pitch = wall.lengthM / axes;
    for (int storey = 0; storey < storeys; ++storey)
        for (int axis = 0; axis < axes; ++axis)
        {
            const double middle = (axis + 0.5) * pitch;
            const double floor = kPlinthM + storey * kGableStoreyM;
            if (storey == 0 && axis == doorAxis)
                wall.openings.push_back(
                    {middle - 0.55, middle + 0.55, floor, floor + kGableHeadM, Detail::door, 0.2, false});
            else
                wall.openings.push_back(
                    {middle - 0.62, middle + 0.62, floor + kGableSillM, floor + kGableHeadM, window});
        }
}

void addEntrance(ModelBuilder& builder, const HouseShell& shell, double doorX, bool hasPosts)
{
    const Surface details{Painting::houseDetails, Coat::matt};
    const double y = -0.5 * shell.widthM;
    const CellUv stone = uvOf(Detail::stone);
    const CellUv wood = uvOf(Detail::wood);
    builder.begin("steps", details);
    addBox(builder, {{doorX - 0.95, y - 1.15, -0.5},
                     {doorX + 0.95, y + 0.1, 0.5 * kPlinthM},
                     stone.at(0, 0),
                     stone.at(1, 1),
                     0.8F});
    addBox(builder, {{doorX - 0.80, y - 0.80, -0.4},
                     {doorX + 0.80, y + 0.1, kPlinthM},
                     stone.at(0, 0),
                     stone.at(1, 1),
                     0.8F});
    builder.begin("canopy", details, glm::vec3(0.85F));
    const double z = kPlinthM + kGableHeadM + 0.14;
    addBox(builder, {{doorX - 1.05, y - 1.20, z},
                     {doorX + 1.05, y + 0.05, z + 0.14},
                     wood.at(0, 0.4F),
                     wood.at(1, 0.6F)});
    if (!hasPosts) return;
    for (const double side : {-0.92, 0.92})
        addBox(builder, {{doorX + side - 0.06, y - 1.10, -0.4},
                         {doorX + side + 0.06, y - 0.98, z},
                         wood.at(0, 0.4F),
                         wood.at(1, 0.6F)});
}

} // namespace

Model makeFamilyHouse(std::uint64_t seed)
{
    Dice dice(seed + 20000);
    HouseShell shell;
    const int storeys = dice.chance(0.45) ? 2 : 1;
    shell.lengthM = dice.between(9.5, 12.5);
    shell.widthM = dice.between(7.8, 9.4);
    shell.rows = {kPlinthM - 0.05};
    for (int storey = 0; storey < storeys; ++storey)
        for (const double height : {storey == 0 ? 0.0 : -1.0, kGableSillM, kGableHeadM})
            if (height >= 0.0) shell.rows.push_back(kPlinthM + storey * kGableStoreyM + height);
    shell.rows.push_back(kPlinthM + storeys * kGableStoreyM + dice.between(0.0, 0.5));
    shell.wallSurface = {Painting::plaster, Coat::matt};
    shell.roofSurface = {Painting::roofTiles, Coat::matt};
    shell.wallTint = dice.oneOf(kPlasterTints);
    shell.roofTint = dice.oneOf(kTileTints);
    shell.frameTint = dice.chance(0.7) ? glm::vec3(1.0F) : glm::vec3(0.45F, 0.30F, 0.20F);
    shell.doorTint = dice.oneOf(kDoorTints);
    Dice mason(seed + 25000); // separate, so that bricks change nothing else of a house
    if (mason.chance(0.3))
    {
        shell.wallSurface.painting = Painting::bricks;
        shell.wallTint = glm::vec3(static_cast<float>(mason.between(0.85, 1.1)));
    }
    setUpShell(shell,
               std::tan(glm::radians(dice.between(storeys == 1 ? 40.0 : 32.0, storeys == 1 ? 48.0 : 40.0))),
               0.55, 0.35);
    const Detail window = dice.chance(0.5) ? Detail::window : Detail::barsWindow;
    const int axes = shell.lengthM > 11.0 ? 4 : 3;
    const int doorAxis = dice.below(axes);
    addAxes(shell.walls[0], storeys, axes, doorAxis, window);
    addAxes(shell.walls[1], storeys, 2, -1, window);
    addAxes(shell.walls[2], storeys, axes, axes - 1 - dice.below(2), window);
    addAxes(shell.walls[3], storeys, 2, -1, window);
    ModelBuilder builder;
    addShell(builder, shell);
    addGableWindows(builder, shell);
    const double side = dice.chance(0.5) ? 1.0 : -1.0;
    addChimney(builder, shell, {side * 0.25 * shell.lengthM, dice.between(0.5, 1.2)},
               dice.between(0.35, 0.7));
    const int dormers = storeys == 1 ? 1 + dice.below(2) : dice.below(2);
    for (int i = 0; i < dormers; ++i)
        addDormer(builder, shell, dormers == 1 ? 0.0 : (i - 0.5) * 0.45 * shell.lengthM,
                  dice.between(0.9, 1.0));
    addEntrance(builder, shell, shell.lengthM * ((doorAxis + 0.5) / axes - 0.5), dice.chance(0.6));
    return builder.finish();
}

} // namespace scenery::models
