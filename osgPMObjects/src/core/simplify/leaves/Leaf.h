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

/// A card as it is now, and what it stands for.
struct Leaf
{
    /// A position without faces, with a wedge: it can be used up to move a corner.
    struct Spare
    {
        std::uint32_t position = 0, wedge = 0;
    };

    LeafCard card;
    glm::dvec3 middle{0.0};      ///< of all cards that it stands for, by what is seen of them
    Extent extent;               ///< around them
    double owedDoubleArea = 0.0; ///< theirs
    double seenDoubleArea = 0.0; ///< theirs, each times its exposure
    double exposure = 0.0;       ///< how far the card was away from all others, by its size, squared
    std::vector<Spare> spares;
    LevelError error;

    Leaf(const CollapseState& state, LeafCard given);
    /// What another one has stood for.
    void takeOver(const Leaf& gone);
};

/// How a card's faces go, collapse by collapse within it.
struct LeafClosing
{
    struct Step
    {
        std::uint8_t from = 0, to = 0; ///< corners
        std::uint32_t faces = 0;       ///< that vanish
    };
    std::vector<Step> steps;
    std::vector<std::uint8_t> left; ///< corners that have not gone
};

/// The edge that most faces have goes first. `isTurned`: its other end is left.
LeafClosing closingOf(const LeafCard& card, bool isTurned);

/// What a leaf becomes when another one goes.
struct LeafGrowth
{
    static constexpr std::uint8_t kOwn = 0xff;

    std::vector<glm::dvec3> places; ///< by corner
    std::vector<std::uint8_t>
        taken;             ///< by corner: the corner of the one that goes whose position it takes; kOwn
    bool isTurned = false; ///< how the one that goes closes
    double cost = 0.0;     ///< what is moved
    double loss = std::numeric_limits<double>::infinity(); ///< that, and the area that is missing or too much

    void weigh(const CollapseState& state, const Leaf& gone, const Leaf& stays);
    bool takesCorners() const;
};

/// With places to choose: the leaf that stays, larger, until it has the area that is seen of both, or fills the box around all that it stands
/// for: larger ones were seen to stick out of the crown. All of its corners move where there are spares enough, else all but one.
LeafGrowth scaledLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays);

/// The leaf that stays, with some corners where the other one's are that show the same of the texture, so that
/// its area is nearest to that of both, none of its faces turned over. It may stay as it is.
LeafGrowth stretchedLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays);

} // namespace osgPMObjects::core
