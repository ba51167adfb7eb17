// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <foundation/Result.h>

#include <osg/StateSet>

#include "measurement/light/LampFigures.h"
#include "measurement/light/LightFigure.h"

namespace measurement
{

/// What scenes make of the weather, which the pictures need: functions of who opens scenes.
struct SceneParts
{
    /// The visibility in air in which "rain" or "snow" falls, in metres.
    std::function<double(const char* type, double mmPerHour)> visibilityM;
    /// How much greyer the whole sky is under a cover; both 0 … 1.
    std::function<double(double cover)> greyUnder;
};

/// What a test changes of pictures that are measured: uniforms of the scene, before each picture.
using Spoiler = std::function<void(osg::StateSet& scene)>;

/// Returns the lamps of an aircraft's wing tips and tail as they are drawn (scenery::lightPointOf).
PositionLamps drawnPositionLamps();

/// Returns a dipped head lamp as others see it from afar (the same).
scenery::LightPoint drawnLowBeam();

/// Measures lamps in pictures: their range, their flux by place and step, the black beside them, the sectors
/// of position lamps and the change of PAPI. Errors: of the offscreen context. Cost: some 800 pictures of
/// 32 x 32 pixels.
foundation::Result<LightFigures> drawnLampFigures(const LampParts& parts = {}, const Spoiler& spoil = {});

/// Measures what contrast is left at the visibility, by day, dusk and night, for ground, road, object and
/// aircraft, in rain and in snow. Errors: of the offscreen context. Cost: some 3 000 pictures of 32 x 18.
foundation::Result<LightFigures> drawnAirFigures(const SceneParts& scenes, const Spoiler& spoil = {});

/// Sweeps the sun's height, the visibility, the cover and the moonlight over pictures of the sky, and holds
/// the light of level ground against daylight and moonlight. Errors: of the offscreen context.
foundation::Result<LightFigures> drawnSkyFigures();

/// Measures cover and base of clouds, and a climb through them, in pictures. Errors: of the offscreen
/// context. Cost: some 2 000 pictures of 48 x 36.
foundation::Result<LightFigures> drawnCloudFigures(const SceneParts& scenes);

} // namespace measurement
