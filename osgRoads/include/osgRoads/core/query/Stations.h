// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace osgRoads::core
{

/// Returns places along a road, metres: from its start to its end, evenly spaced, `mostApartM` apart at most;
/// two or more.
inline std::vector<double> evenStations(double lengthM, double mostApartM)
{
    const int steps = std::max(static_cast<int>(std::ceil(lengthM / mostApartM)), 1);
    std::vector<double> stations;
    for (int i = 0; i <= steps; ++i)
        stations.push_back(lengthM * i / steps);
    return stations;
}

} // namespace osgRoads::core
