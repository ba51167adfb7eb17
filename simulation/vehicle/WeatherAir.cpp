// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/WeatherAir.h"

#include <cmath>
#include <numbers>

namespace simulation
{

namespace
{

/// The share of its peak that a gust has at a time.
double gustShare(const Gust& gust, double timeS)
{
    const double share = gust.lengthS > 0.0 ? (timeS - gust.startS) / gust.lengthS : -1.0;
    if (share < 0.0 || share > 1.0) return 0.0;
    return 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * share));
}

} // namespace

AirSample WeatherAir::at(const glm::dvec3& /*position*/, double heightM, double timeS) const
{
    const AirState still = standardAtmosphere(heightM, _weather.offsets);
    return {still.densityKgPerM3,
            still.pressurePa,
            still.temperatureK,
            _weather.windMps + gustShare(_weather.gust, timeS) * _weather.gust.peakMps,
            _weather.windAtSixMetresMps,
            _weather.gustDeviationMps};
}

} // namespace simulation
