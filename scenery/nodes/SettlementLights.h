// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <utility>
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
/// points. By day the posts alone are drawn; what is seen by night alone is made when it is lit first.
/// Frame: the scene's. Needs the uniforms of an Atmosphere and LightUniforms above it. Threads: made
/// anywhere; light() in the update phase.
class SettlementLights
{
public:
    /// `others`: as light points alone. Lamps beyond the ground are left out. `ground` is asked when the
    /// lamps are lit first, too.
    SettlementLights(const std::vector<StreetLamp>& lamps, std::vector<WindowPane> panes,
                     std::vector<LightPoint> others, foundation::HeightInPlan ground);

    osg::Group* node() const { return _root.get(); }

    /// How many light points there are.
    std::size_t count() const { return _count; }

    /// `levels`: of all groups.
    void light(const LightLevels& levels);

private:
    /// A street lamp, and the height of the ground at its post.
    using StandingLamp = std::pair<StreetLamp, double>;

    /// What lamps and windows are made of.
    struct Unlit
    {
        std::vector<StandingLamp> lamps;
        std::vector<WindowPane> panes;
        std::vector<LightPoint> others;
        foundation::HeightInPlan ground;
    };

    void showPoints(std::span<const LightPoint> points);
    void makeLights(const Unlit& from);

    std::optional<Unlit> _unlit; ///< absent: all is made
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
