// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

namespace osgPMObjects::core
{

/// Tells which positions of the coarsest level the faces of other levels need. A position that no step
/// removes is in every level, but the faces that use it may all have vanished, as those of most leaves of a
/// tree.
class NeededPositions
{
public:
    explicit NeededPositions(const ProgressiveMesh& progressive);

    /// Marks what the faces need that the level after `steps` steps has, there and at all coarser levels.
    /// Call it with falling numbers.
    /// Cost: linear in the faces of the level.
    void addLevel(std::uint32_t steps);

    bool isNeeded(std::size_t position) const { return _isNeeded[position]; }

private:
    const ProgressiveMesh& _progressive;
    ProgressiveLevel _level;
    std::vector<bool> _isFollowed; ///< by wedge
    std::vector<bool> _isNeeded;   ///< by position
};

} // namespace osgPMObjects::core
