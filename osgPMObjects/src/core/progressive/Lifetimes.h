// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

#include "SplitOrder.h"

namespace osgPMObjects::core
{

/// A table of when each face vanishes, computed before a walk down the levels begins.
class Lifetimes
{
public:
    explicit Lifetimes(const SplitOrder& split);

    /// Returns the number of steps after which a face has vanished; the number of all steps plus one: never.
    std::uint32_t end(std::uint32_t face) const { return _ends[face]; }

    /// Returns the wedge that replaces a wedge of a face after `steps` steps.
    std::uint32_t wedgeAfter(std::uint32_t wedge, std::uint32_t steps) const
    {
        const std::size_t positionsLeft = _split.mesh.positions.size() - steps;
        while (_split.mesh.wedgePositions[wedge] >= positionsLeft)
            wedge = _split.parents[wedge];
        return wedge;
    }

private:
    const SplitOrder& _split;
    std::vector<std::uint32_t> _ends; ///< by face
};

} // namespace osgPMObjects::core
