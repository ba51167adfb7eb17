// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

#include "../collapse/CollapseState.h"
#include "LeafCards.h"

namespace osgPMObjects::core
{

/// A card in its current form, with the sums of all cards merged into it.
struct Leaf
{
    /// A position without faces, and a wedge of it: a later step may use them to move a corner.
    struct Spare
    {
        std::uint32_t position = 0, wedge = 0;
    };

    LeafCard card;
    glm::dvec3 middle{0.0};      ///< of all cards merged into it, weighted by visible area
    Extent extent;               ///< the box around them
    double owedDoubleArea = 0.0; ///< the sum of their areas
    double seenDoubleArea = 0.0; ///< the sum of their areas, each times its exposure
    double exposure = 0.0;       ///< squared distance of the card from all others, in units of its size
    std::vector<Spare> spares;
    LevelError error;

    Leaf(const CollapseState& state, LeafCard given);
    /// Adds the sums of a card that is removed.
    void takeOver(const Leaf& gone);
};

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

/// Collapses the edge with the most faces first. `isTurned`: in the other direction, so that its other end is left.
LeafClosing closingOf(const LeafCard& card, bool isTurned);

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

/// Scales the remaining leaf to the visible area of both, but not beyond the box around all cards merged into it: larger leaves
/// visibly stick out of the crown. All corners move when there are spare positions enough, else all but one. Not for subset
/// placement.
LeafGrowth scaledLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays);

/// Moves corners of the remaining leaf to corners of the other with the same texture coordinates, so that its area comes
/// nearest to that of both, and turns none of its faces over. The leaf may stay as it is.
LeafGrowth stretchedLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays);

} // namespace osgPMObjects::core
