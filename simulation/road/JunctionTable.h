// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "simulation/road/JunctionLane.h"
#include "simulation/road/LaneMeetings.h"
#include "simulation/road/RoadScene.h"

namespace simulation
{

/// What the lanes through junctions have to do with each other, and which lanes go on for ever. Answers are
/// worked out when they are asked for first. Threads: one.
/// Source: ASAM OpenDRIVE 1.8, 12 (junctions); signs by the German catalogue (Straßenverkehrs-Ordnung, § 8,
/// § 9 and annexes 2 and 3).
class JunctionTable
{
public:
    /// `roads` must outlive it.
    explicit JunctionTable(const RoadScene& roads) : _roads(&roads), _meetings(roads) {}

    const RoadScene& roads() const { return *_roads; }

    /// Where lanes that do not belong to one junction meet.
    LaneMeetings& meetings() { return _meetings; }

    /// The index of the junction that a road belongs to; -1: to none.
    int junctionOf(int road) const;

    /// Null: both may be driven at once. So may two that begin in one lane, where one follows the other.
    const LaneConflict* conflict(const JunctionLane& own, const JunctionLane& other);

    /// How far a lane turns, positive to the left. Radians.
    double turnRad(const JunctionLane& lane) { return shapeOf(lane).turnRad; }

    /// Whether a lane leads on around a roundabout.
    bool staysInRing(const JunctionLane& lane);

    /// Whether `other` goes before `own`: by priorities of the junction, by signs to give way, to stop or of
    /// a road with priority, by a roundabout's ring; of two that face each other whoever does not turn across
    /// the way of the other; else whoever comes from the right, from the left in left-hand traffic.
    /// `byLights`: traffic lights let both pass, so that neither signs nor priorities hold.
    bool goesBefore(const JunctionLane& other, const JunctionLane& own, bool byLights = false);

    /// Whether a lane that is entered there leads to no end of the roads within a kilometre, on one way at
    /// least. Where all roads end, all do.
    bool leadsOn(const JunctionLane& lane);

private:
    /// A vehicle on a lane, by its rear axle.
    struct Body
    {
        glm::dvec2 place{0.0};
        double headingRad = 0.0;
        double alongM = 0.0; ///< of the lane; negative: before it
    };

    /// What a vehicle needs on a lane: one a metre.
    struct Shape
    {
        std::vector<Body> bodies;
        int incoming = -1;        ///< road that leads there
        bool comesForward = true; ///< along that road
        bool isInRing = false;
        double turnRad = 0.0; ///< positive: to the left
    };

    enum class Sign
    {
        none,
        givesWay,
        hasPriority
    };

    const Shape& shapeOf(const JunctionLane& lane);
    Shape shaped(const JunctionLane& lane) const;
    void findIncoming(const JunctionLane& lane, Shape& shape) const;
    bool isRing(int road, bool isForward) const;
    Sign signOf(const Shape& shape) const;
    bool decide(const JunctionLane& other, const JunctionLane& own, bool byLights);
    std::optional<bool> byPriority(const JunctionLane& other, const JunctionLane& own);
    void findEnds();

    const RoadScene* _roads;
    LaneMeetings _meetings;
    std::map<JunctionLane, Shape> _shapes;
    std::map<std::pair<JunctionLane, JunctionLane>, std::pair<bool, LaneConflict>> _conflicts;
    std::map<std::pair<JunctionLane, JunctionLane>, bool> _before, _beforeByLights;
    bool _hasEnds = false;
    std::map<JunctionLane, double> _endsAfterM; ///< of lanes that lead to ends alone
};

} // namespace simulation
