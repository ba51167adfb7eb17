// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <osgRoads/core/network/RoadNetwork.h>

namespace osgRoads::core
{

enum class FlawKind
{
    gap,           ///< positions that do not meet
    kink,          ///< headings that do not meet
    step,          ///< heights that do not meet
    negativeWidth, ///< of a lane, or a border on the wrong side of the one inside it
    overlap,       ///< lanes of two roads that are not linked lie over each other
    danglingLane,  ///< a lane link to a lane that is not there
    oneWayLink,    ///< a link that the other side does not answer
};

/// The word that programs print.
const char* wordOf(FlawKind kind);

/// Something that does not fit in a network that has been read.
struct Flaw
{
    FlawKind kind = FlawKind::gap;
    int line = 0; ///< in the file
    std::string what, remedy;
    double size = 0.0; ///< metres or radians

    std::string message(const std::string& file) const
    {
        return file + ":" + std::to_string(line) + ": " + what + "; " + remedy;
    }
};

/// How much is allowed.
struct JointLimits
{
    double elementGapM = 0.001; ///< between elements of one reference line
    double elementKinkRad = 0.01;
    double laneGapM = 0.01; ///< between the middles of linked lanes, in the plan view
    double laneKinkRad = 0.05;
    double laneStepM = 0.05;  ///< in height, also of a road's own elevation
    double widthJumpM = 0.05; ///< of a lane's width or border within its section
};

/// Compares the ends of neighbouring elements of each reference line.
std::vector<Flaw> checkElementJoints(const RoadNetwork& network, const JointLimits& limits = {});

/// What joints of linked lanes were compared, and what was found.
struct LaneJoints
{
    std::size_t count = 0;
    std::vector<Flaw> flaws;
};

/// Compares the middles of linked lanes where two roads meet, also over junctions. Each joint is looked at
/// once.
LaneJoints checkLaneJoints(const RoadNetwork& network, const JointLimits& limits = {});

} // namespace osgRoads::core
