// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects::core
{

/// Tells for each vertex of a level where a coarser level has it: the end positions of a geomorph between the
/// two. With all vertices at their targets, the faces that the coarser level does not have are without area.
/// Memory: 8 B for each wedge that only the finer level has.
/// Source: Hoppe, "Progressive meshes" (1996), §3.1 (geomorphs). Differs: positions and attributes are
/// followed apart.
struct MorphTargets
{
    struct Target
    {
        /// A wedge of the coarser level whose position is the target; the same for all wedges of one
        /// position.
        std::uint32_t positionWedge = 0;
        /// The wedge whose attributes are the target. It may lie at another position: where all faces of a
        /// wedge vanish, its attributes stop there.
        std::uint32_t attributeWedge = 0;
        bool operator==(const Target&) const = default;
    };

    std::uint32_t firstWedge = 0; ///< wedges before it belong to both levels and do not move
    std::vector<Target> targets;  ///< of the finer level's wedges, from firstWedge on
};

/// Finds the targets between two levels: `finerSteps` ≤ `coarserSteps` ≤ ProgressiveMesh::stepCount.
/// Cost: linear in the finer level's wedges.
MorphTargets morphTargets(const ProgressiveMesh& progressive, std::uint32_t finerSteps,
                          std::uint32_t coarserSteps);

} // namespace osgPMObjects::core
