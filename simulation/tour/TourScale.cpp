// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/TourScale.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>
#include <foundation/Earth.h>

namespace simulation
{
namespace
{

constexpr double kLargestBankDeg = 24.0;
constexpr double kLargestTurnDegPerS = 6.0;
constexpr double kLargestClimbDeg = 8.0;
constexpr double kLargestSinkDeg = 13.0;
constexpr double kSightsMps = 110.0; ///< at most where there is something to look at

} // namespace

TourScale TourScale::of(const TourTerrain& terrain, double durationS)
{
    const double side = std::max(terrain.widthM(), terrain.depthM());
    TourScale scale;
    scale.speedMps = std::min(std::clamp(side / 50.0, 15.0, terrain.sights.empty() ? 240.0 : kSightsMps),
                              0.5 * side / durationS);
    scale.lengthM = scale.speedMps * durationS;
    scale.mediumM = 0.1 * std::min(scale.lengthM, 20.0 * scale.speedMps);
    scale.lowM = 0.55 * scale.mediumM;
    scale.highM = 1.7 * scale.mediumM;
    scale.clearanceM = 0.3 * scale.mediumM;
    scale.turnRateRadPerS = std::min(foundation::radiansOf(kLargestTurnDegPerS),
                                     foundation::kStandardGravityMps2 *
                                         std::tan(foundation::radiansOf(kLargestBankDeg)) / scale.speedMps);
    scale.climbSlope = std::tan(foundation::radiansOf(kLargestClimbDeg));
    scale.sinkSlope = std::tan(foundation::radiansOf(kLargestSinkDeg));
    return scale;
}

} // namespace simulation
