// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

namespace osgPMObjects::core
{

/// Calls visit(triangle, group) for each face of a level in the order in which it is drawn; holes are
/// skipped.
template<class Visit>
void forEachDrawnFace(const ProgressiveMesh& progressive, const ProgressiveLevel& level, const Visit& visit)
{
    std::vector<SlotRange> ranges;
    for (std::uint32_t group = 0; group < progressive.groups.size(); ++group)
    {
        ranges.clear();
        level.appendRanges(group, ranges);
        for (const SlotRange& range : ranges)
            for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
                if (const Triangle face = level.face(slot); !repeatsCorner(face)) visit(face, group);
    }
}

/// Returns the level after `steps` steps as a plain mesh, with its faces in the order in which
/// ProgressiveLevel draws them. All faces get one part, for a progressive mesh does not keep parts. Cost:
/// that of playing `steps` steps.
Mesh meshAfter(const ProgressiveMesh& progressive, std::uint32_t steps);

} // namespace osgPMObjects::core
