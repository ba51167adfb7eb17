// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "simulation/road/BodyBox.h"
#include "simulation/road/JunctionLane.h"
#include "simulation/road/RoadScene.h"

namespace simulation
{

/// A stretch of a lane. Units: metres along the lane, of the rear axle, from where the lane is entered.
struct LaneStretch
{
    double fromM = 0.0, toM = 0.0;
};

/// Where vehicles on two lanes have no room beside each other, outside the junctions' own tables: in narrow
/// bends, on one track for both directions, before and behind a junction where others swing out, and where
/// maps draw streets into each other. Found from the bodies of two that are moved along the lanes; not of
/// two lanes of one road and direction, nor where one lane goes on as the other.
/// Answers are worked out when they are asked for first. Threads: one.
class LaneMeetings
{
public:
    /// `roads` must outlive it.
    explicit LaneMeetings(const RoadScene& roads) : _roads(&roads) {}

    /// The stretches of a lane, in its direction, on which it meets other lanes.
    const std::vector<LaneStretch>& narrowOn(const JunctionLane& lane) { return knownOf(lane).narrow; }

    /// Another lane, and where both meet.
    using Met = std::pair<JunctionLane, std::vector<LaneConflict>>;

    /// The lanes that a lane meets, in their order.
    const std::vector<Met>& metBy(const JunctionLane& lane) { return knownOf(lane).others; }

    /// The lane under a place that looks along it, as it is entered; nothing: there is none.
    std::optional<JunctionLane> laneAt(const RoadPlace& place) const;

    /// How far a point is along a lane.
    double alongM(const JunctionLane& lane, const glm::dvec2& point);

private:
    /// A vehicle on a lane.
    struct Body
    {
        BodyBox box;
        glm::dvec2 axle{0.0};
        double heightM = 0.0, alongM = 0.0;
    };
    struct Bodies
    {
        std::vector<Body> all; ///< one a metre
        int endLane = 0;       ///< of the road, where the lane leaves it
        glm::dvec2 least{0.0}, most{0.0};
    };
    struct Known
    {
        std::vector<Met> others;
        std::vector<LaneStretch> narrow;
    };

    const Known& knownOf(const JunctionLane& lane);
    const Bodies& bodiesOf(const JunctionLane& lane);
    Bodies bodiesAlong(const JunctionLane& lane) const;
    std::vector<JunctionLane> lanesNear(const JunctionLane& lane);
    bool areApart(const JunctionLane& own, const JunctionLane& other);
    bool goesOnAs(const JunctionLane& own, const JunctionLane& other, double withinM);
    std::vector<LaneConflict> met(const JunctionLane& own, const JunctionLane& other);

    const RoadScene* _roads;
    std::map<JunctionLane, Bodies> _bodies;
    std::map<JunctionLane, Known> _known;
};

} // namespace simulation
