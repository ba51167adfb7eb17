// SPDX-License-Identifier: Apache-2.0
#include "FlyRequest.h"

#include <cmath>

#include <foundation/Angle.h>
#include <foundation/Units.h>

namespace trainer
{

glm::dvec2 FlyRequest::windMps() const
{
    if (wind.empty()) return glm::dvec2(0.0);
    const double from = foundation::radiansOf(wind[0]);
    return -foundation::kMpsPerKnot * wind[1] * glm::dvec2(std::sin(from), std::cos(from));
}

void FlyRequest::takeReportedWind()
{
    if (!wind.empty() || !play.weather || !play.weather->wind) return;
    const auto& [towardsRad, speedMps] = *play.weather->wind;
    const double fromDeg = 270.0 - foundation::degreesOf(towardsRad); // headings turn the other way round
    wind = {fromDeg - 360.0 * std::floor(fromDeg / 360.0), speedMps / foundation::kMpsPerKnot};
}

} // namespace trainer
