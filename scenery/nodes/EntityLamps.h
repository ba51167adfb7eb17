// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <osg/Geometry>
#include <osg/Group>

#include "scenery/models/entities/EntityModel.h"
#include "scenery/nodes/LampGlow.h"
#include "scenery/nodes/LightPoints.h"
#include "simulation/state/EntityState.h"

namespace scenery
{

/// Returns the lamps that a driver has on where no action says otherwise: the brake lamps while the entity
/// slows down by more than 0.5 m/s², the reversing lamps while it goes backwards, and head and tail lamps in
/// the dark. Those of an aircraft are on as its parts say; strobes and the beacon flash by `timeS`, once in
/// 1.2 s and in 1 s.
models::LitLamps defaultLamps(const simulation::EntityState& state, bool isDark, double timeS = 0.0);

/// Returns a lamp as a light point: of an aircraft with the sectors and intensities of 14 CFR 23.1391 and
/// 23.1401, of a road vehicle with usual ones of UN R112, R7 and R6. Frame: the entity's.
LightPoint lightPointOf(const models::EntityLamp& lamp);

/// The lamps of one entity. Those that are lit shine by themselves, with a glow about them, and by night as
/// light points from afar; the others are not drawn, so that the lenses of the model are seen. Frame: the
/// entity's. Threads: light() in the update phase.
class EntityLamps
{
public:
    /// All lamps begin dark.
    explicit EntityLamps(std::vector<models::EntityLamp> lamps);

    /// Null when there are no lamps.
    osg::Node* node() const { return _node.get(); }

    void light(const models::LitLamps& lit);

private:
    std::vector<models::EntityLamp> _lamps;
    models::LitLamps _lit{};
    osg::ref_ptr<osg::Vec4Array> _colours = new osg::Vec4Array;
    std::optional<LampGlow> _glow;
    std::optional<LightPoints> _points;
    osg::ref_ptr<osg::Group> _node;
};

} // namespace scenery
