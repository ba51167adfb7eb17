// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects::core
{

/// Where the vertices of a level are in a coarser one, for a geomorph between the two. With all of them there, faces that the coarser level
/// has not are without area, and the others are its faces.
/// Memory: 8 B a wedge that goes.
/// Source: Hoppe, "Progressive meshes" (1996), §3.1 (geomorphs). Differs: positions and attributes are followed apart.
struct MorphTargets
{
    struct Target
    {
        /// A wedge that lies where this one goes. The same for all wedges of a position.
        std::uint32_t place = 0;
        /// The wedge whose attributes it takes. Not always of that place: a wedge whose faces have all vanished on the way has ended there.
        std::uint32_t look = 0;
        bool operator==(const Target&) const = default;
    };

    std::uint32_t firstWedge = 0; ///< those before are of the coarser level, too, and stay
    std::vector<Target> targets;  ///< of the finer level's wedges from firstWedge on
};

/// `finerSteps`: at most `coarserSteps`, which are at most as many as there are. Cost: linear in the finer level's wedges.
MorphTargets morphTargets(const ProgressiveMesh& progressive, std::uint32_t finerSteps,
                          std::uint32_t coarserSteps);

} // namespace osgPMObjects::core
