// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/houses/TownHouses.h"

#include "scenery/models/Dice.h"
#include "scenery/models/houses/HouseColours.h"
#include "scenery/models/houses/HouseShell.h"
#include "scenery/models/houses/RoofFittings.h"
#include "scenery/models/mesh/Box.h"

namespace scenery::models
{

namespace
{

constexpr double kGroundFloorM = 3.9;
constexpr double kTownStoreyM = 3.05;
constexpr double kTownSillM = 0.80;
constexpr double kTownHeadM = 2.45;
constexpr double kShopHeadM = 3.0;

struct Unit
{
    double middleX, widthM, depthM, liftM;
    int storeys, axes;
    int doorAxis;
};

double floorOf(int storey)
{
    return kPlinthM + (storey == 0 ? 0.0 : kGroundFloorM + (storey - 1) * kTownStoreyM);
}

std::vector<double> rowsOf(const Unit& unit)
{
    std::vector<double> rows{kPlinthM - 0.05, kPlinthM, kPlinthM + 0.55, kPlinthM + kShopHeadM};
    for (int storey = 1; storey < unit.storeys; ++storey)
        rows.insert(rows.end(), {floorOf(storey) + kTownSillM, floorOf(storey) + kTownHeadM});
    rows.push_back(floorOf(unit.storeys) + 0.3 + unit.liftM);
    return rows;
}

void addFacade(Wall& wall, const Unit& unit, bool isStreet, Detail window)
{
    const double pitch = wall.lengthM / unit.axes;
    for (int axis = 0; axis < unit.axes; ++axis)
    {
        const double middle = (axis + 0.5) * pitch;
        if (axis == unit.doorAxis)
            wall.openings.push_back({middle - 0.65, middle + 0.65, kPlinthM, kPlinthM + kShopHeadM,
                                     Detail::glassDoor, 0.3, false});
        else if (isStreet)
            wall.openings.push_back({middle - 0.42 * pitch, middle + 0.42 * pitch, kPlinthM + 0.55,
                                     kPlinthM + kShopHeadM, Detail::shopFront, 0.2});
        for (int storey = 1; storey < unit.storeys; ++storey)
            wall.openings.push_back({middle - 0.60, middle + 0.60, floorOf(storey) + kTownSillM,
                                     floorOf(storey) + kTownHeadM, window, 0.16});
    }
}

void addCornices(ModelBuilder& builder, const HouseShell& shell, const Unit& unit)
{
    builder.begin("cornice", {Painting::houseDetails, Coat::matt}, glm::vec3(0.95F));
    const CellUv uv = uvOf(Detail::white);
    const double y = -0.5 * unit.depthM;
    const auto add = [&](double z, double highM, double proudM)
    {
        addBox(builder, {{unit.middleX - 0.5 * unit.widthM + 0.03, y - proudM, z},
                         {unit.middleX + 0.5 * unit.widthM - 0.03, y + 0.05, z + highM},
                         uv.at(0, 0.3F),
                         uv.at(1, 0.4F)});
    };
    add(floorOf(1) - 0.35, 0.30, 0.16);
    add(floorOf(unit.storeys) - 0.15, 0.22, 0.12);
    add(shell.rows.back() - 0.38, 0.30, 0.26);
}

void addUnit(ModelBuilder& builder, const Unit& unit, Dice& dice)
{
    HouseShell shell;
    shell.middle = {unit.middleX, 0.0, 0.0};
    shell.lengthM = unit.widthM - 0.02; // walls of neighbours are not in one plane
    shell.widthM = unit.depthM;
    shell.rows = rowsOf(unit);
    shell.wallSurface = {Painting::plaster, Coat::matt};
    shell.roofSurface = {Painting::roofTiles, Coat::matt};
    shell.wallTint = dice.oneOf(kPlasterTints) * static_cast<float>(dice.between(0.86, 1.0));
    shell.roofTint = dice.oneOf(kTileTints);
    shell.doorTint = dice.oneOf(kDoorTints);
    setUpShell(shell, dice.between(0.70, 0.95), 0.38, 0.06);
    const Detail window = dice.chance(0.5) ? Detail::window : Detail::barsWindow;
    addFacade(shell.walls[0], unit, true, window);
    addFacade(shell.walls[2], unit, false, window);
    addShell(builder, shell);
    addCornices(builder, shell, unit);
    addChimney(builder, shell, {0.5 * unit.widthM - 0.6, dice.between(0.4, 1.4)}, 0.5);
    for (int i = 0; i < 2; ++i)
        addDormer(builder, shell, (i - 0.5) * 0.5 * unit.widthM, 1.2);
}

} // namespace

Model makeTownHouses(std::uint64_t seed)
{
    Dice dice(seed + 30000);
    const int units = 2 + dice.below(3);
    const double depthM = dice.between(10.5, 12.0);
    std::vector<Unit> row;
    double widthM = 0.0;
    for (int i = 0; i < units; ++i)
    {
        Unit unit{};
        unit.axes = 3 + dice.below(2);
        unit.widthM = unit.axes * dice.between(2.3, 2.6);
        unit.middleX = widthM + 0.5 * unit.widthM;
        unit.depthM = depthM;
        unit.storeys = 3 + dice.below(3);
        unit.liftM = 0.25 * (i % 2) + dice.between(0.0, 0.1); // roofs of neighbours are not in one plane
        unit.doorAxis = dice.below(unit.axes);
        widthM += unit.widthM;
        row.push_back(unit);
    }
    ModelBuilder builder;
    for (Unit& unit : row)
    {
        unit.middleX -= 0.5 * widthM;
        addUnit(builder, unit, dice);
    }
    return builder.finish();
}

} // namespace scenery::models
