// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

#include "../collapse/CollapseState.h"
#include "../parts/LeafCards.h"

namespace osgPMObjects::core
{

/// A card in its current form, with the sums of all cards merged into it.
struct Leaf
{
    LeafCard card;
    glm::dvec3 middle{0.0};      ///< of all cards merged into it, weighted by visible area
    Extent extent;               ///< the box around them
    double owedDoubleArea = 0.0; ///< the sum of their areas
    double seenDoubleArea = 0.0; ///< the sum of their areas, each times its exposure
    std::uint32_t count = 1;     ///< of the cards merged into it, itself included
    double exposure = 0.0;       ///< squared distance of the card from all others, in units of its size
    std::vector<LeafCard::Corner>
        spares; ///< of removed cards, without faces: a later step may use them to move a corner
    LevelError error;

    Leaf(const CollapseState& state, LeafCard given);
    /// The box that the card may fill: that around all cards merged into it, wider the more they are, but
    /// within the mesh's box. A few large cards have gaps between them that many small ones did not.
    Extent room(const Extent& box) const;
    /// Adds the sums of a card that is removed.
    void takeOver(const Leaf& gone);
};

/// Returns the positions of a card's corners.
std::vector<glm::dvec3> cornerPositions(const CollapseState& state, const LeafCard& card);

glm::dvec3 centroidOf(std::span<const glm::dvec3> places);

/// Returns the normal of a face, of twice its area's length. `places`: by corner of the card.
glm::dvec3 doubleAreaVector(const LeafCard::Corners& c, std::span<const glm::dvec3> places);

/// Returns twice the area of a card whose corners are at `places`.
double doubleAreaOf(const LeafCard& card, std::span<const glm::dvec3> places);

} // namespace osgPMObjects::core
