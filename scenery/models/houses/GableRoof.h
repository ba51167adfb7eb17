// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// A gable roof: a slab bent along its ridge. `base`: the point below the ridge at the height where the lower
/// side of the slab meets the walls. `axis`: along the ridge, unit length, level. Units: metres.
struct GableRoof
{
    glm::dvec3 base{0.0}, axis{1.0, 0.0, 0.0};
    double from = -1.0, to = 1.0; ///< along the axis, overhang included
    double halfWidth = 1.0;       ///< from the ridge to the walls
    double overhang = 0.5;        ///< beyond them, level
    double slope = 0.8;           ///< rise over run
    double thickness = 0.2;       ///< upright

    double ridgeM() const { return halfWidth * slope; } ///< of the underside, above the base
    /// Returns the height of the upper side above the base at a distance from the ridge.
    double topAt(double acrossM) const { return (halfWidth - acrossM) * slope + thickness; }
    glm::dvec3 across() const { return {-axis.y, axis.x, 0.0}; }
};

/// The period of the roof texture in metres, in both axes.
constexpr double kRoofPictureM = 2.4;

/// Adds the closed roof: tiles above, boards below and at the edges, a row of ridge tiles, and a gutter along
/// each eave where asked for.
void addGableRoof(ModelBuilder& builder, const GableRoof& roof, const Surface& tiles, const glm::vec3& tint,
                  bool hasGutters);

} // namespace scenery::models
