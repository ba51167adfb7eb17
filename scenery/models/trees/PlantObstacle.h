// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/Catalogue.h"
#include "simulation/contact/Obstacle.h"

namespace scenery::models
{

/// A generated plant where it stands, as vehicles meet it: a trunk by its kind, or a bush that slows. The
/// seeds of a kind differ in height; this is one of the middle.
simulation::Obstacle plantObstacle(Kind kind, const glm::dvec3& foot, double scale);

/// The height in the middle of those of a kind's seeds. Units: metres.
inline double meanHeightM(Kind kind)
{
    const KindFacts& facts = factsOf(kind);
    return 0.5 * (facts.leastHeightM + facts.mostHeightM);
}

} // namespace scenery::models
