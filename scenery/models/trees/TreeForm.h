// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// A range that seeds choose from.
struct Range
{
    double low, high;
};

/// The parameters of a kind of tree. Shares are of the height if not said otherwise. Units: metres, degrees
/// above level.
struct TreeForm
{
    Range heightM;
    Range crownFrom;    ///< where the crown begins
    Range crownRadius;  ///< half its greatest width
    double trunkRadius; ///< at breast height
    double trunkTo;     ///< where the trunk ends
    double trunkWander; ///< its deviation from a straight line
    int stems;          ///< trunks out of one root
    double (*profile)(
        double crownShare); ///< share of the greatest width, from the crown's base (0) to its top (1)

    int boughs;
    Range boughElevationDeg; ///< at the crown's base, at its top
    double boughBend;        ///< bends up by that share of its length; negative: down
    int twigsPerBough;
    double twigSpreadDeg; ///< away from the bough

    int cardsPerTwig;
    Range cardM;      ///< length of a leaf card
    double cardWidth; ///< share of its length
    double cardHang;  ///< 0: along its twig, 1: straight down
    bool flatCards;   ///< level sprays instead of random attitudes

    Painting bark, leaves;
    glm::dvec2 barkRepeats; ///< around the trunk, along it per metre
    glm::vec3 leafTint;     ///< mean; seeds vary it
};

enum class TreeKind
{
    oak,
    birch,
    poplar,
    spruce,
    bush,
};

const TreeForm& treeForm(TreeKind kind);

} // namespace scenery::models
