// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osg/Group>

#include <osgPMObjects/ProgressiveField>

#include "scenery/nodes/RoadLamps.h"
#include "scenery/roads/things/RoadThings.h"

namespace scenery
{

/// Everything beside and over roads as two fields of progressive models, and the lamps of traffic lights,
/// which shine by themselves.
/// To make it: RoadThingsNode::create(roads::placeRoadThings(placedNetwork, groundHeight)), then add node()
/// to a group that has the uniforms of an Atmosphere. `groundHeight` may be empty.
/// Frame: the scene's. Threads: setState() in the update phase. Cost: 1 to 10 ms a distinct model, 0.3 to 1 s
/// a kind of plant.
class RoadThingsNode
{
public:
    /// Errors: as ProgressiveField::setContents().
    static foundation::Result<std::unique_ptr<RoadThingsNode>> create(const roads::RoadThings& things);

    osg::Group* node() const { return _root.get(); }
    /// What stands beside roads, and of it what is no higher than a person and made for one place: rails,
    /// fences.
    const std::vector<osg::ref_ptr<osgPMObjects::ProgressiveField>>& fields() const { return _fields; }

    /// Sets what a traffic light shows. Returns false when there is no light of that id. All begin at stop.
    bool setState(const std::string& signalId, LightState state) { return _lamps->setState(signalId, state); }

    /// The same by the words stop, attention, go, caution and off, in English or as OpenSCENARIO files write
    /// them (red, green, yellow), or by a list of its lenses from the top, as in `on;off;off`. Returns false
    /// for other words, too.
    bool setState(const std::string& signalId, const std::string& state);

private:
    osg::ref_ptr<osg::Group> _root;
    std::vector<osg::ref_ptr<osgPMObjects::ProgressiveField>> _fields;
    std::unique_ptr<RoadLamps> _lamps;
};

} // namespace scenery
