// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/simplify/Simplify.h>

#include "../star/Star.h"

namespace osgPMObjects::core
{

/// The cost of a change of area: what an eye at any side sees of thin parts, whose ends have quadrics of
/// almost no weight, and of spikes.
struct AreaCost
{
    Placement placement = Placement::subset;
    double weight = 0.0;
    /// The longest way on which the last faces of a part are moved to keep their area, by the root of twice
    /// the area of the part at the start: placeKeepingArea(). 0: they are not moved, as within an envelope,
    /// and where parts join instead of growing.
    double mostSwelling = 0.0;

    /// `sizeOfParts`: meanSize(). In a scattered model a part is small against the whole, but its silhouette
    /// is all that the eye sees of it, so its area counts more. zone_maisons-ba, parts of .02: 93 % of the
    /// silhouettes at 5 % instead of 30.
    /// `hasFoliage`: the model has a crown of leaf cards, which share no scale with thin parts: with subset
    /// placement trunks and twigs would keep faces that the crown needs.
    static AreaCost forModel(const SimplifySettings& settings, double sizeOfParts, bool hasFoliage = false);

    /// Computes the cost of a collapse. `star`: of the position that goes; `change`: of twice the area of the
    /// faces around both. With optimal placement it grows with the cube of the change, so that fine levels do
    /// without it. Subset placement cannot move vertices outwards: only the faces of thin parts have a cost
    /// there, that of a displacement by the root of the change. Quality placement weighs the mean distance
    /// alone.
    double of(const Star& star, double change) const;
};

/// Returns how much the faces of a star look in opposite directions: 0 for a plane, near 1 at the end of a
/// tube, 1 for two faces back to back.
double thinnessOf(const Star& star);

} // namespace osgPMObjects::core
