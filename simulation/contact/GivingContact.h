// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/contact/Obstacle.h"

namespace simulation
{

/// A box of a vehicle as it lies now: upright, by its plan and its height.
struct HullPlan
{
    glm::dvec2 middle{0.0}, along{1.0, 0.0}, halfM{1.0};
    double lowM = 0.0, highM = 1.0;
};

/// Whether a box and a thing overlap: by the axes of both in the plan (Gottschalk, Lin, Manocha, *OBBTree*,
/// SIGGRAPH 1996, section 5, in two dimensions), and by their heights.
bool overlaps(const HullPlan& hull, const Obstacle& obstacle);

/// What a thing that gives does to a vehicle whose point there moves so.
struct GivingBlow
{
    double impulseNs = 0.0; ///< against the motion
    bool breaks = false;
};

/// The blow of something that breaks or slows. It never turns the motion round: the impulse is at most that
/// which stops the point, so that no energy is made. `inverseMass`: the speed that an impulse of 1 N s there
/// changes, 1/kg. What breaks at more than the vehicle can give stands fast.
GivingBlow blowOf(ObstacleKind kind, double speedMps, double massKg, double inverseMass, double stepS);

} // namespace simulation
