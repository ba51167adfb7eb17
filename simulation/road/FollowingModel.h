// SPDX-License-Identifier: Apache-2.0
// Source: Treiber, Hennecke, Helbing, *Congested traffic states in empirical observations and microscopic
// simulations*, Physical Review E 62, 2000, equations 3 and 4 (intelligent driver model).
#pragma once

#include <algorithm>
#include <cmath>

namespace simulation
{

/// Somebody who follows whoever is ahead, or comes up to a line to stop at. Units: m/s, m, m/s².
struct Following
{
    double speedMps = 0.0;
    double gapM = 0.0; ///< to whoever is ahead, free
    double leadMps = 0.0;
    double standM = 0.0;                                   ///< kept to one who stands: s0
    double headwayM = 0.0;                                 ///< kept beside it at this speed: v·T
    double accelerationMps2 = 0.0, decelerationMps2 = 0.0; ///< comfortable: a, b
};

/// How much whoever is ahead slows one down, as a share of the acceleration on a free road: (s* / s)² with
/// s* = s0 + max(0, v·T + v·Δv / (2·√(a·b))). A gap below 0.1 m counts as 0.1 m.
inline double crowding(const Following& own)
{
    constexpr double kTouchingM = 0.1, kLeast = 0.01;
    const double brakes = 2.0 * std::sqrt(std::max(own.accelerationMps2 * own.decelerationMps2, kLeast));
    const double closing = own.speedMps - own.leadMps;
    const double wanted = own.standM + std::max(0.0, own.headwayM + own.speedMps * closing / brakes);
    const double ratio = wanted / std::max(own.gapM, kTouchingM);
    return ratio * ratio;
}

} // namespace simulation
