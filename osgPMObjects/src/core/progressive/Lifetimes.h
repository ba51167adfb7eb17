// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

#include "SplitOrder.h"

namespace osgPMObjects::core
{

/// What becomes of faces and wedges, known before a walk down the levels begins.
class Lifetimes
{
public:
    explicit Lifetimes(const SplitOrder& split);

    /// After how many steps a face is gone; one more than there are: never.
    std::uint32_t end(std::uint32_t face) const { return _ends[face]; }

    /// What a wedge has become after some steps, as far as faces use it.
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
