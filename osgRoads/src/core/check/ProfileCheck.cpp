// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 10.5.1 (elevation), 11.6 (lane width): both are continuous along a road.
#include <cmath>
#include <string>
#include <vector>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/read/Problem.h>

namespace osgRoads::core
{

namespace
{

using Jump = ElevationStep; ///< of any profile

/// Finds the jumps of a profile between 0 and its end. Of pieces that begin at one place the last one counts.
std::vector<Jump> jumpsOf(const CubicProfile& profile, double end, double limit)
{
    std::vector<Jump> jumps;
    const std::vector<Cubic>& pieces = profile.pieces();
    const Cubic* holds = nullptr;
    for (std::size_t i = 0; i < pieces.size() && pieces[i].s < end; ++i)
    {
        if (i + 1 < pieces.size() && pieces[i + 1].s == pieces[i].s) continue;
        const double size = holds ? std::fabs(pieces[i].a - holds->value(pieces[i].s)) : 0.0;
        if (size > limit && pieces[i].s > 0.0) jumps.push_back({pieces[i].s, size});
        holds = &pieces[i];
    }
    return jumps;
}

void checkElevation(const Road& road, double limit, std::vector<Flaw>& flaws)
{
    for (const Jump& jump : elevationSteps(road, limit))
        flaws.push_back({FlawKind::step, road.line,
                         "road " + road.id + " at s " + shortNumber(jump.s) + ": the elevation jumps by " +
                             shortNumber(jump.size) + " m",
                         "let its pieces meet", jump.size});
}

void checkWidth(const Road& road, const LaneSection& section, const Lane& lane, double limit,
                std::vector<Flaw>& flaws)
{
    for (const Jump& jump : jumpsOf(lane.width, section.end - section.s, limit))
        flaws.push_back({FlawKind::gap, lane.line,
                         "road " + road.id + " at s " + shortNumber(section.s + jump.s) + ": the " +
                             (lane.isByBorder ? "border" : "width") + " of lane " + std::to_string(lane.id) +
                             " jumps by " + shortNumber(jump.size) + " m",
                         "let its pieces meet", jump.size});
}

} // namespace

std::vector<ElevationStep> elevationSteps(const Road& road, double limitM)
{
    return jumpsOf(road.elevation, road.length, limitM);
}

std::vector<Flaw> checkProfiles(const RoadNetwork& network, const JointLimits& limits)
{
    std::vector<Flaw> flaws;
    for (const Road& road : network.roads)
    {
        if (!road.isUsable) continue;
        checkElevation(road, limits.laneStepM, flaws);
        for (const LaneSection& section : road.sections)
            for (const auto* side : {&section.left, &section.right})
                for (const Lane& lane : *side)
                    checkWidth(road, section, lane, limits.widthJumpM, flaws);
    }
    return flaws;
}

} // namespace osgRoads::core
