// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
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
    static constexpr std::uint32_t kNoSpare = 0xffffffff;

    std::vector<glm::dvec3> places; ///< by corner: its new position
    std::vector<std::uint8_t>
        taken; ///< by corner: the corner of the other card whose position it takes; kOwn: none
    /// By corner: the spare position that it goes to; kNoSpare: none. Empty: none at all.
    std::vector<std::uint32_t> spares;
    bool isTurned = false; ///< direction in which the other card closes
    double cost = 0.0;     ///< of moving
    double loss =
        std::numeric_limits<double>::infinity(); ///< the cost, and the difference to the wanted area

    void weigh(const CollapseState& state, const Leaf& gone, const Leaf& stays);
    bool takesCorners() const;
};

/// Scales the remaining leaf to the visible area of both, but not beyond its room (Leaf::room()): larger
/// leaves visibly stick out of the crown. All corners move when there are spare positions enough, else all
/// but one. Not for subset placement.
LeafGrowth scaledLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays);

/// For subset placement: moves each corner of the remaining leaf to the spare position with the same texture
/// coordinates that is nearest to where scaledLeaf() would move it, or somewhat farther out, unless that
/// turns a face over. Spare positions are those of all cards that have merged into either leaf.
LeafGrowth leafOfSpares(const CollapseState& state, const Leaf& gone, const Leaf& stays);

/// Tells whether two corners have the same texture coordinates, but for SimplifySettings::mostTexCoordDrift.
bool looksTheSame(const CollapseState& state, const LeafCard::Corner& a, const LeafCard::Corner& b);

/// Tells whether no face of a card turns over and the card stays about flat when its corners move.
bool keepsItsSide(const LeafCard& card, std::span<const glm::dvec3> before,
                  std::span<const glm::dvec3> after);

/// Moves corners of the remaining leaf to corners of the other with the same texture coordinates, so that its
/// area comes nearest to that of both, and turns none of its faces over. The leaf may stay as it is.
LeafGrowth stretchedLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays);

} // namespace osgPMObjects::core
