// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/Climate>

#include "TileableNoise.h"

namespace osgTerrainROAM
{

/// What the rule of vegetation and snow asks of a point of the ground.
struct GroundSite
{
    double heightM;
    double steepness; ///< tangent of the slope
    double southness; ///< −1 faces away from the midday sun … 1 faces it
    double hollow;    ///< SkyVisibility.h
    double noise;     ///< −½…½, patches of many sizes: GroundRule::noiseAt()
};

/// The rule that gives vegetation and snow by height, slope, hollows, the slope's side to the sun, and noise.
/// All numbers were chosen by eye. Threads: immutable.
class GroundRule
{
public:
    /// `spacingM`: between samples, the mean of both directions.
    GroundRule(const Climate& climate, double spacingM);

    /// 0 rock, 0.25 scree and soil, 0.5 grass, 0.75 meadow and shrub, 1 forest.
    double vegetation(const GroundSite& site) const;
    /// ½: half covered.
    double snow(const GroundSite& site) const;

    /// Noise by position in metres, −½…½: periods of 60 samples (300 m … 6 km), and of 3.73 times that,
    /// rotated.
    double noiseAt(double eastM, double northM) const;

private:
    Climate _climate;
    double _slopeGain, _finePeriodM;
    TileableNoise _noise;
};

} // namespace osgTerrainROAM
