// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <osg/Group>
#include <osg/MatrixTransform>

#include "scenery/lights/PapiUnits.h"
#include "scenery/nodes/LightPoints.h"

namespace scenery
{

/// Lights and windsocks of airfields: PAPI and other lamps as light points, the housings of PAPI, and
/// windsocks that the wind turns and lifts.
/// Frame: the scene's. Needs the uniforms of an Atmosphere and LightUniforms above it. Threads: setWind() and
/// light() in the update phase.
class AirfieldNode
{
public:
    /// `socks`: the feet of windsocks. `lights`: all lamps but those of the PAPI.
    AirfieldNode(std::span<const PapiUnit> papis, std::span<const glm::dvec3> socks,
                 std::vector<LightPoint> lights = {});

    osg::Group* node() const { return _root.get(); }

    /// `windMps`: to where the air moves, east and north. Calm lets socks hang; 7.7 m/s (15 kt) lifts them
    /// level.
    void setWind(const glm::dvec2& windMps);

    /// Hides lamps of which no group is on.
    void light(const LightLevels& levels);

private:
    osg::ref_ptr<osg::Group> _root = new osg::Group;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> _socks;
    std::vector<glm::dvec3> _tops;
    std::optional<LightPoints> _lights;
};

} // namespace scenery
