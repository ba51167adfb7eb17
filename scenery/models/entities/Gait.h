// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/entities/EntityModel.h"

namespace scenery::models
{

/// A walk: each foot stands for half a stride and swings for the other half. Units: metres.
struct Gait
{
    double strideM = 1.2; ///< covered from one step of a foot to the next of the same foot
    double liftM = 0.1;   ///< of a swinging foot

    /// The share of the full step: 0 standing, 1 from a slow walk on.
    static double vigour(double speedMps);

    /// Returns how far around its stride a foot is, 0…1. `offset`: its share of the stride ahead of the first
    /// foot.
    double phase(double odometerM, double offset) const;
};

/// The place of a foot relative to the point below its hip.
struct FootPlace
{
    double aheadM = 0.0, aboveM = 0.0;
    double toeDownRad = 0.0;
};

/// Returns the place of a foot. A standing foot keeps its place on the ground at full vigour, because it
/// moves back as far as the body moves ahead.
FootPlace footPlace(const Gait& gait, const EntityMotion& motion, double offset);

} // namespace scenery::models
