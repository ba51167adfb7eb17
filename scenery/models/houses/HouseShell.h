// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "scenery/models/houses/GableRoof.h"
#include "scenery/models/houses/Wall.h"

namespace scenery::models
{

/// A rectangular house below one gable roof, about the z axis, with its ridge along x. Units: metres.
struct HouseShell
{
    glm::dvec3 middle{0.0};
    double lengthM = 10.0, widthM = 8.0;
    std::vector<double> rows;  ///< heights of all walls; the roof rests on the last
    GableRoof roof;            ///< base, slope and width follow from the walls
    std::array<Wall, 4> walls; ///< front (towards -y), right (+x), back, left
    Surface wallSurface, roofSurface;
    glm::vec3 wallTint{1.0F}, roofTint{1.0F}, frameTint{1.0F}, doorTint{1.0F};
    bool hasGutters = true;
};

/// Makes walls and roof from sizes and rows. Openings are added to the walls afterwards.
void setUpShell(HouseShell& shell, double slope, double eavesM, double vergeM);

/// Adds walls, openings, sills, roof, plinth and downpipes to a model.
void addShell(ModelBuilder& builder, const HouseShell& shell);

/// The depth of a plinth in the ground, and its height above it.
constexpr double kFoundationM = 1.0;
constexpr double kPlinthM = 0.30;

} // namespace scenery::models
