// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <osg/StateSet>
#include <osg/Uniform>

#include "simulation/environment/SurfaceWeather.h"

namespace scenery
{

/// Water, snow and ice on ground, roads and what stands there, as programs that contain
/// Atmosphere::glslFunctions() show them. On a dry ground it costs nothing: they are compiled without it, and
/// anew when the first water or snow comes. Threads: the update phase.
class SurfaceLook
{
public:
    /// `scene`: the state of all that lies in the open.
    explicit SurfaceLook(osg::StateSet& scene);

    /// `groundM`: height of the ground at the origin, to which depths are told. Frame: world. Below it snow
    /// thins out over 600 m, from where it is 1.5 °C, or, where no temperature is told, from 230 m below it,
    /// as in air of 0 °C. Source: U.S. Standard Atmosphere (1976): 6.5 °C a kilometre.
    void show(const simulation::SurfaceWeather& ground, double groundM,
              const std::optional<double>& temperatureK);

private:
    osg::ref_ptr<osg::StateSet> _scene;
    osg::ref_ptr<osg::Uniform> _wetness, _weather, _snowLine;
};

} // namespace scenery
