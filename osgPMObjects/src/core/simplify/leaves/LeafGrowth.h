// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "../collapse/CollapseState.h"
#include "Leaf.h"

namespace osgPMObjects::core
{

/// The changes of a leaf when another one merges into it.
struct LeafGrowth
{
    static constexpr std::uint8_t kOwn = 0xff;

    std::vector<glm::dvec3> places; ///< by corner: its new position
    std::vector<std::uint8_t>
        taken;             ///< by corner: the corner of the other card whose position it takes; kOwn: none
    bool isTurned = false; ///< direction in which the other card closes
    double cost = 0.0;     ///< of moving
    double loss =
        std::numeric_limits<double>::infinity(); ///< the cost, and the difference to the wanted area

    void weigh(const CollapseState& state, const Leaf& gone, const Leaf& stays);
    bool takesCorners() const;
};

/// Scales the remaining leaf to the visible area of both, but not beyond its room (Leaf::room()): larger leaves visibly stick out of
/// the crown. All corners move when there are spare positions enough, else all but one. Not for subset
/// placement.
LeafGrowth scaledLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays);

/// Moves corners of the remaining leaf to corners of the other with the same texture coordinates, so that its area comes
/// nearest to that of both, and turns none of its faces over. The leaf may stay as it is.
LeafGrowth stretchedLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays);

} // namespace osgPMObjects::core
