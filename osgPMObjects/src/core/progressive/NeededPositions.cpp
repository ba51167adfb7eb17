// SPDX-License-Identifier: Apache-2.0
#include "NeededPositions.h"

#include <osgPMObjects/core/progressive/LevelMesh.h>

namespace osgPMObjects::core
{

NeededPositions::NeededPositions(const ProgressiveMesh& progressive)
    : _progressive(progressive),
      _level(progressive),
      _isFollowed(progressive.mesh.wedgeCount(), false),
      _isNeeded(progressive.mesh.positions.size(), false)
{
}

void NeededPositions::addLevel(std::uint32_t steps)
{
    _level.moveTo(steps);
    forEachDrawnFace(_progressive, _level,
                     [this](const Triangle& face, std::uint32_t)
                     {
                         // At coarser levels a corner has the parent of its wedge.
                         for (std::uint32_t wedge : face)
                             while (!_isFollowed[wedge])
                             {
                                 _isFollowed[wedge] = true;
                                 _isNeeded[_progressive.mesh.wedgePositions[wedge]] = true;
                                 wedge = _progressive.parents[wedge];
                             }
                     });
}

} // namespace osgPMObjects::core
