// SPDX-License-Identifier: Apache-2.0
#include "Lifetimes.h"

#include "LevelWalk.h"

namespace osgPMObjects::core
{

Lifetimes::Lifetimes(const SplitOrder& split)
    : _split(split), _ends(split.mesh.faces.size(), static_cast<std::uint32_t>(split.errors.size()) + 1)
{
    LevelWalk walk(split);
    while (walk.stepsTaken() < walk.stepCount())
    {
        walk.step();
        for (const std::uint32_t face : walk.vanished())
            _ends[face] = walk.stepsTaken();
    }
}

} // namespace osgPMObjects::core
