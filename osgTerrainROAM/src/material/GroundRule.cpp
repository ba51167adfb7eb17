// SPDX-License-Identifier: Apache-2.0
#include "GroundRule.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace osgTerrainROAM
{

namespace
{

} // namespace

// Coarse samples smooth slopes: the real ones, which hold trees and snow, are steeper.
GroundRule::GroundRule(const Climate& climate, double spacingM)
    : _climate(climate),
      _slopeGain(std::clamp(std::pow(spacingM / 10.0, 0.2), 0.8, 1.5)),
      _finePeriodM(std::clamp(spacingM * 60.0, 300.0, 6000.0)),
      _noise(256, {4, 5, 0.6, 71})
{
}

double GroundRule::vegetation(const GroundSite& p) const
{
    const double line = _climate.treeLineM + 120.0 * p.southness + 300.0 * p.noise;
    const double below = line - p.heightM;
    const double band = std::max(0.12 * _climate.treeLineM, 120.0);
    double green = 0.30 + 0.32 * glm::smoothstep(-3.2 * band, -0.5 * band, below) +
                   0.36 * glm::smoothstep(-0.6 * band, 1.1 * band, below);
    green -= 0.25 * glm::smoothstep(-1.5 * band, -5.0 * band, below);
    // Valley floors and gentle ground are open land, slopes carry the woods.
    const double gentle = 1.0 - glm::smoothstep(0.04, 0.16, p.steepness * _slopeGain);
    green -= 0.33 * gentle * glm::smoothstep(0.5 * band, 1.5 * band, below) *
             glm::smoothstep(-0.25, 0.1, p.hollow + 0.5 * p.noise);
    green += 0.75 * p.noise + 0.25 * std::clamp(p.hollow, -0.6, 0.6);
    // Below the tree line roots hold slopes; above it such slopes are scree.
    const double holds = 0.75 + 0.45 * glm::smoothstep(-band, band, below);
    green -= 0.95 * glm::smoothstep(holds, holds + 0.7, p.steepness * _slopeGain);
    return std::clamp(green * (1.0 - 0.72 * _climate.aridity) + 0.06 * _climate.aridity, 0.0, 1.0);
}

double GroundRule::snow(const GroundSite& p) const
{
    const double line =
        _climate.snowLineM + 250.0 * p.southness - 220.0 * std::clamp(p.hollow, -0.7, 0.7) + 350.0 * p.noise;
    const double deep = glm::smoothstep(-450.0, 450.0, p.heightM - line);
    return deep * (1.0 - 0.85 * glm::smoothstep(0.9, 1.7, p.steepness * _slopeGain));
}

double GroundRule::noiseAt(double eastM, double northM) const
{
    const double fine = _finePeriodM, coarse = 3.73 * _finePeriodM;
    return 0.6 * _noise.sample(eastM / fine, northM / fine) +
           0.6 * _noise.sample((0.8 * eastM - 0.6 * northM) / coarse, (0.6 * eastM + 0.8 * northM) / coarse) -
           0.6;
}

} // namespace osgTerrainROAM
