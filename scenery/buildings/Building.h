// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scenery/lights/RoomUse.h"
#include "scenery/models/Model.h"

namespace scenery
{

enum class RoofForm : std::uint8_t
{
    flat,
    gabled,
    hipped,
    pyramidal,
    skillion, ///< one slope
    round,    ///< an arc over the shorter side
};

/// What the walls have openings for.
enum class Openings : std::uint8_t
{
    none,
    house,   ///< windows in each storey, and a door
    hangar,  ///< gates over most of both gables
    control, ///< a band of glass around the highest storey, and a door: a tower of an airfield
};

/// A building on its footprint. Frame: the scene's east and north. Units: metres; colours as display values.
struct Building
{
    std::vector<std::vector<glm::dvec2>>
        rings;           ///< the outer one counter-clockwise, then courtyards clockwise
    double eavesM = 6.0; ///< of the walls above the floor, without the roof
    double roofM = 2.5;  ///< of the roof above the eaves
    double liftedM =
        0.0; ///< of a part over a passage: its underside above the floor; below it there is nothing
    bool isOnPosts = false; ///< the lifted part is a roof without walls, on posts
    RoofForm roof = RoofForm::gabled;
    bool isRidgeAcross = false; ///< the ridge lies along the shorter side
    int storeys = 2;
    Openings openings = Openings::house;
    bool hasShop = false;
    RoomUse rooms = RoomUse::dwelling;
    models::Painting wall = models::Painting::plaster, cover = models::Painting::roofTiles;
    glm::vec3 wallTint{1.0F}, roofTint{0.6F, 0.36F, 0.28F}, doorTint{0.42F, 0.26F, 0.16F};
};

/// A building on the ground. Units: metres in the scene's z.
struct StandingBuilding
{
    Building building;
    double floorM = 0.0;                        ///< of its ground floor
    double footM = 0.0;                         ///< where its walls begin, in the ground
    std::vector<std::vector<double>> groundM{}; ///< at the corners of its rings; empty: level with the floor
    std::size_t doorEdge = 0; ///< of the outer ring, from this corner to the next: the side of the street

    /// Returns the ground at a share of the way along an edge of a ring.
    double groundAt(std::size_t ring, std::size_t edge, double share) const
    {
        if (groundM.empty()) return floorM;
        const std::vector<double>& corners = groundM[ring];
        return std::lerp(corners[edge], corners[(edge + 1) % corners.size()], share);
    }
};

} // namespace scenery
