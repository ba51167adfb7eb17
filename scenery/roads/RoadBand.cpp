// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/RoadBand.h"

#include <algorithm>
#include <cmath>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace scenery
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::RoadMatch;

/// The band at `outM` from lanes whose surface has the height `laneM` there.
HeightBand bandBeside(double laneM, double outM, const RoadCutShape& shape)
{
    const auto& bed = shape.bed;
    if (outM <= bed.vergeM)
    {
        const double risen = std::clamp((outM - bed.vergeM + shape.riseM) / shape.riseM, 0.0, 1.0);
        const double height = laneM - bed.vergeFall * outM - std::lerp(bed.depthM, shape.vergeEndM, risen);
        return {height, height};
    }
    const double edgeM = laneM - bed.vergeFall * bed.vergeM - shape.vergeEndM;
    const double beyondM = outM - bed.vergeM, leftM = shape.reachM - outM;
    if (leftM <= 0.0) return {};
    const double halfM = shape.slope * beyondM * (1.0 + beyondM / leftM);
    return {edgeM - halfM, edgeM + halfM};
}

/// The band that one road asks for.
HeightBand bandOf(const PlacedNetwork& roads, const RoadMatch& match,
                  const osgTerrainROAM::core::TileFrame& frame, const RoadCutShape& shape)
{
    const auto& position = match.position;
    const auto& road = roads.road(position.road);
    if (osgRoads::core::structureAt(road, position.s)) return {};
    const auto lanes = osgRoads::core::extentAt(road, position.s);
    const double t = std::clamp(position.t, lanes.rightT, lanes.leftT);
    const double laneM = frame.heightOf(roads.surfacePoint(position.road, position.s, t));
    // Beyond an end no mesh covers a bed: there the ground is that beside the verge.
    const bool isBeyondEnd = match.distance > 1e-6 && t == position.t;
    return bandBeside(laneM, match.distance + (isBeyondEnd ? shape.bed.vergeM + 1e-9 : 0.0), shape);
}

} // namespace

HeightBand roadBand(const PlacedNetwork& roads, const osgTerrainROAM::core::TileFrame& frame,
                    const RoadCutShape& shape, const glm::dvec3& scene)
{
    HeightBand band;
    const glm::dvec2 plan(roads.toInertial(scene));
    for (const RoadMatch& match : roads.locator().within(plan, shape.reachM))
    {
        const HeightBand asked = bandOf(roads, match, frame, shape);
        band.lowM = std::max(band.lowM, asked.lowM);
        band.highM = std::min(band.highM, asked.highM);
    }
    return band;
}

} // namespace scenery
