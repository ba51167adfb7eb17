// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "../parts/LeafCards.h"

namespace osgPMObjects::core
{

/// The order in which a card's faces are removed, by collapses within it.
struct LeafClosing
{
    struct Step
    {
        std::uint8_t from = 0, to = 0; ///< corners
        std::uint32_t faces = 0;       ///< number of faces that vanish
    };
    std::vector<Step> steps;
    std::vector<std::uint8_t> left; ///< corners that are left
};

/// Collapses the edge with the most faces first. `isTurned`: in the other direction, so that its other end is
/// left.
LeafClosing closingOf(const LeafCard& card, bool isTurned);

} // namespace osgPMObjects::core
