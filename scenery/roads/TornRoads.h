// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osgRoads/core/network/RoadNetwork.h>

namespace scenery
{

/// The stretches of roads around steps of their own elevation that no ground can follow. There the ground is
/// left as it is, so that it goes over from one height to the other in a slope; the road is drawn as the file
/// has it.
/// Units: metres. Threads: const, any.
class TornRoads
{
public:
    static constexpr double kStepM = 2.0;       ///< smaller steps are banks
    static constexpr double kFarthestM = 200.0; ///< of a stretch from its step

    explicit TornRoads(const osgRoads::core::RoadNetwork& network);

    /// Whether s of a road lies in such a stretch.
    bool at(int road, double s) const;

    /// Returns a line for each step, most ten, and one for the number of the others.
    std::vector<std::string> notes(const osgRoads::core::RoadNetwork& network, const std::string& file) const;

private:
    struct Stretch
    {
        double s = 0.0, size = 0.0, halfM = 0.0;
    };

    std::vector<std::vector<Stretch>> _ofRoads;
};

} // namespace scenery
