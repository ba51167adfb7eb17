// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/HoldingSigns.h"

#include <algorithm>

#include <foundation/NearestOnSegment.h>

#include "scenery/roads/things/Placers.h"

namespace scenery
{

namespace
{

using models::RoadModel;
using osgTerrainROAM::core::HoldingPosition;

constexpr double kLongRunwayM = 1200.0;
constexpr double kClearM = 2.0; ///< from the edges of other paving
constexpr double kApartM = 4.0;

RoadModel signOf(const HoldingPosition& position)
{
    const bool isLong = position.runwayM >= kLongRunwayM;
    RoadModel model;
    model.kind = RoadModel::Kind::runwaySign;
    model.heightM = isLong ? 0.8 : 0.6;
    model.widthM = std::max(isLong ? 1.94 : 1.46,
                            0.43 * model.heightM * static_cast<double>(position.runways.size() + 1));
    model.raisedM = 0.3;
    model.postDepthM = models::kPostDepthM;
    model.text = position.runways;
    return model;
}

bool isOn(const PavedWay& way, const glm::dvec2& place)
{
    return foundation::distanceToLine(place, way.middle) < 0.5 * way.widthM + kClearM;
}

} // namespace

roads::RoadThings holdingSigns(std::span<const HoldingPosition> positions, std::span<const PavedWay> paved,
                               const foundation::HeightInPlan& ground)
{
    roads::RoadThings signs;
    for (const HoldingPosition& position : positions)
        for (const double side : {1.0, -1.0})
        {
            const RoadModel model = signOf(position);
            const double fromEdgeM = position.runwayM >= kLongRunwayM ? 11.0 : 5.0;
            const glm::dvec2 left(-position.away.y, position.away.x);
            const glm::dvec2 place =
                position.place + side * (0.5 * position.taxiwayM + fromEdgeM + 0.5 * model.widthM) * left;
            const auto heightM = ground(place);
            const auto isNear = [&](const roads::StandingThing& other)
            { return glm::distance(glm::dvec2(other.position), place) < kApartM; };
            if (!heightM ||
                std::any_of(paved.begin(), paved.end(),
                            [&](const PavedWay& way) { return isOn(way, place); }) ||
                std::any_of(signs.standing.begin(), signs.standing.end(), isNear))
                continue;
            roads::StandingThing sign;
            sign.position = glm::dvec3(place, *heightM);
            sign.axes = glm::dmat3(glm::dvec3(-position.away, 0.0), glm::dvec3(-left, 0.0),
                                   glm::dvec3(0.0, 0.0, 1.0));
            roads::addStanding(signs, model, sign);
        }
    return signs;
}

} // namespace scenery
