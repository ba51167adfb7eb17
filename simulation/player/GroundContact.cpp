// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/GroundContact.h"

#include <algorithm>
#include <cmath>

namespace simulation
{
namespace
{

constexpr double kSmallestSpreadM = 0.05;
constexpr int kRounds = 3;

} // namespace

GroundContact GroundContact::of(const ScenarioObject& object)
{
    if (const auto* vehicle = std::get_if<Vehicle>(&object.object); vehicle && vehicle->frontAxle)
    {
        const double track = 0.5 * (vehicle->frontAxle->trackWidthM + vehicle->rearAxle.trackWidthM);
        return {vehicle->frontAxle->positionXM, vehicle->rearAxle.positionXM, 0.5 * track};
    }
    const BoundingBox& box = object.box();
    return {box.centre.x + 0.5 * box.lengthM, box.centre.x - 0.5 * box.lengthM, 0.5 * box.widthM};
}

void standOnGround(const GroundContact& contact, const SceneFrame& frame, EntityState& state)
{
    const double ch = std::cos(glm::radians(state.headingDeg));
    const double sh = std::sin(glm::radians(state.headingDeg));
    const double front = std::max(contact.frontXM, contact.rearXM + kSmallestSpreadM);
    const double rear = contact.rearXM;
    const double half = std::max(contact.halfTrackM, 0.5 * kSmallestSpreadM);
    EntityState placed = state;
    placed.pitchDeg = 0.0;
    placed.rollDeg = 0.0;
    for (int round = 0; round < kRounds; ++round)
    {
        // Plan distances shrink with the slope, as the body does.
        const double along = std::cos(glm::radians(placed.pitchDeg));
        const double across = std::cos(glm::radians(placed.rollDeg));
        std::array<double, 4> heights{};
        for (std::size_t i = 0; i < heights.size(); ++i)
        {
            const double x = (i < 2 ? front : rear) * along;
            const double y = (i % 2 == 0 ? half : -half) * across;
            const auto ground = frame.groundAt(state.position.x + ch * x - sh * y,
                                               state.position.y + sh * x + ch * y, state.position.z);
            if (!ground) return;
            heights[i] = ground->heightM;
        }
        const double frontMean = 0.5 * (heights[0] + heights[1]);
        const double rearMean = 0.5 * (heights[2] + heights[3]);
        const double riseAhead = (frontMean - rearMean) / ((front - rear) * along);
        const double riseLeft = 0.25 * (heights[0] - heights[1] + heights[2] - heights[3]) / (half * across);
        placed.position.z = rearMean - riseAhead * rear * along;
        placed.pitchDeg = glm::degrees(-std::atan(riseAhead));
        placed.rollDeg = glm::degrees(std::atan(riseLeft * std::cos(std::atan(riseAhead))));
        const double twist = 0.25 * (heights[0] - heights[1] - heights[2] + heights[3]);
        placed.wheelTravelM = {twist, -twist, -twist, twist};
    }
    placed.isOnGround = true;
    state = placed;
}

} // namespace simulation
