// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "scenery/models/roads/Sweep.h"
#include "scenery/roads/things/RoadThings.h"

namespace scenery::roads
{

using Profile = std::vector<glm::dvec2>; ///< to the left and up from the surface at (s, t), metres

/// A body swept along a road from s to sEnd. `lineT(s)`: where; `profileAt(s)`: its cross-section.
struct RoadLine
{
    double s = 0.0, sEnd = 0.0;
    double stepM = 4.0; ///< between cross-sections
    models::Surface surface = models::kPlain;
    glm::vec3 tint{0.6F};
    double uvPerM = 0.0;
    std::function<double(double)> lineT;
    std::function<Profile(double)> profileAt;

    std::optional<simulation::ObstacleKind> body{}; ///< as which vehicles meet it; absent: they do not
    double bodyTopM = 0.0;                          ///< it reaches so high at least, over the surface
    /// vehicles drive through: the body is that of both walls
    bool isTube = false;
};

/// Adds the body, cut into pieces of at most kPieceM, each of which has levels of its own.
void addRoadLine(const osgRoads::core::PlacedNetwork& placed, int road, const RoadLine& line,
                 RoadThings& into);

constexpr double kPieceM = 96.0;

} // namespace scenery::roads
