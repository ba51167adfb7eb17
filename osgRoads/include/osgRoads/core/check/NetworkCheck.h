// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <osgRoads/core/check/JointCheck.h>

namespace osgRoads::core
{

/// Finds lanes whose width is negative somewhere, or whose border crosses that of the lane inside. One flaw a
/// lane. Rounding of a taper (1 mm) is allowed.
std::vector<Flaw> checkLaneWidths(const RoadNetwork& network);

/// Finds pairs of roads whose lanes for cars lie over each other at the same height (1 m), though the roads
/// are neither linked nor parts of one junction, nor joined to a junction that the other belongs to. One flaw
/// a pair; its size is the number of sample points, 5 m apart on the middle of lanes.
std::vector<Flaw> checkOverlaps(const RoadNetwork& network);

/// A place of a road where its own elevation jumps. Units: metres.
struct ElevationStep
{
    double s = 0.0, size = 0.0;
};

/// Finds the jumps of a road's elevation that are larger than a limit, in the order of s.
std::vector<ElevationStep> elevationSteps(const Road& road, double limitM);

/// Finds places within a road where its elevation, or within a lane section the width or border of a lane,
/// jumps.
std::vector<Flaw> checkProfiles(const RoadNetwork& network, const JointLimits& limits = {});

/// Finds links between roads that the other road does not answer.
std::vector<Flaw> checkBackLinks(const RoadNetwork& network);

/// What all checks found.
struct NetworkFlaws
{
    std::size_t laneJoints = 0; ///< compared
    std::vector<Flaw> flaws;    ///< by line

    std::size_t count(FlawKind kind) const;
};

NetworkFlaws checkNetwork(const RoadNetwork& network, const JointLimits& limits = {});

} // namespace osgRoads::core
