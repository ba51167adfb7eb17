// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/SurfaceLook.h"

#include <algorithm>

#include <foundation/Units.h>

namespace scenery
{

SurfaceLook::SurfaceLook(osg::StateSet& scene)
    : _scene(&scene),
      _wetness(new osg::Uniform("roadWetness", 0.0F)),
      _weather(new osg::Uniform("surfaceWeather", osg::Vec4f())),
      _snowLine(new osg::Uniform("surfaceSnowLine", osg::Vec2f()))
{
    for (const auto& uniform : {_wetness, _weather, _snowLine})
        _scene->addUniform(uniform);
}

void SurfaceLook::show(const simulation::SurfaceWeather& ground, double groundM,
                       const std::optional<double>& temperatureK)
{
    constexpr double kLiesBelowC = 1.5, kLapseCPerM = 0.0065, kFadesM = 600.0;
    if (ground.waterMm > 0.0 || ground.snowCm > 0.0) _scene->setDefine("SURFACE_WEATHER");
    using foundation::kZeroCelsiusK;
    const double airC = temperatureK.value_or(kZeroCelsiusK) - kZeroCelsiusK;
    const double lineM = groundM + std::min((airC - kLiesBelowC) / kLapseCPerM, 0.0);
    const auto wetness = static_cast<float>(simulation::wetnessOf(ground.waterMm));
    _wetness->set(wetness);
    _weather->set(osg::Vec4f(wetness, static_cast<float>(ground.snowCm), ground.isIcy ? 1.0F : 0.0F,
                             ground.areRoadsCleared ? 1.0F : 0.0F));
    _snowLine->set(osg::Vec2f(static_cast<float>(lineM), static_cast<float>(1.0 / kFadesM)));
}

} // namespace scenery
