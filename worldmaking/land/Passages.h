// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "scenery/buildings/StandBuildings.h"
#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"
#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// A house that a street runs through: what stands beside the street, and what spans it.
struct PassageParts
{
    std::vector<PlanRings> beside, over;
};

/// The passages of streets through houses (tunnel=building_passage, covered=yes).
class Passages
{
public:
    Passages(const LandMap& map, const MapPlane& plane);

    /// Parts an outline along the passages through it, `roomM` beside their lanes; nothing where none runs
    /// through it. Source: GEOS, through OGR.
    std::optional<PassageParts> part(const PlanRings& rings, double roomM) const;

private:
    struct Passage
    {
        std::vector<glm::dvec2> line;
        double halfM;
    };
    std::vector<Passage> _passages;
    PlanGrid _grid;
};

inline constexpr double kPassageM =
    scenery::kPassedM; ///< free height; houses lower than kLeastPassedM leave a gap
inline constexpr double kLeastPassedM = 6.0;

} // namespace worldmaking
