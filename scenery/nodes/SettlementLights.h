// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <foundation/Heights.h>

#include <osg/Group>
#include <osg/Program>
#include <osg/Uniform>

#include "scenery/buildings/BuildingFacets.h"
#include "scenery/lights/StreetLamps.h"
#include "scenery/nodes/LightPoints.h"

namespace scenery
{

/// The lamps of villages and towns: street lamps with their posts and the ground that they light, windows
/// whose rooms are lit, and other lamps that stand there, near by as what they are and from afar as light
/// points. By day the posts alone are drawn.
/// Frame: the scene's. Needs the uniforms of an Atmosphere and LightUniforms above it. Threads: made
/// anywhere; light() in the update phase.
class SettlementLights
{
public:
    /// `others`: as light points alone. Lamps beyond the ground are left out.
    SettlementLights(std::span<const StreetLamp> lamps, std::span<const WindowPane> panes,
                     std::vector<LightPoint> others, const foundation::HeightInPlan& ground);

    osg::Group* node() const { return _root.get(); }

    /// How many light points there are.
    std::size_t count() const { return _count; }

    /// `levels`: of all groups.
    void light(const LightLevels& levels);

private:
    osg::ref_ptr<osg::Group> _root = new osg::Group;
    osg::ref_ptr<osg::Group> _windows, _pools; ///< null: none
    osg::ref_ptr<osg::Uniform> _poolLevel;
    std::optional<LightPoints> _points;
    std::size_t _count = 0;
};

/// The programs of lit windows and of the ground below street lamps.
osg::ref_ptr<osg::Program> makeWindowProgram();
osg::ref_ptr<osg::Program> makeLampPoolProgram();

} // namespace scenery
