// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osg/Group>

#include <osgPMObjects/ProgressiveField>

#include "scenery/nodes/SceneryShapes.h"
#include "scenery/placement/PlaceScenery.h"

namespace scenery
{

/// All objects of a scenery as one field, below a group that lights those without a shader of their own. Kinds are pairs of
/// a description's field and object, as each field has settings of its own.
/// Frame: the scene's; needs the uniforms of an Atmosphere above it.
struct SceneryNode
{
    osg::ref_ptr<osg::Group> root;
    osg::ref_ptr<osgPMObjects::ProgressiveField> field;
};

/// Errors: selection that cannot be with an object's levels, with `place` and the field's name; as ProgressiveField::setContents().
foundation::Result<SceneryNode> makeSceneryNode(const SceneryDescription& description,
                                                const PlacedScenery& placed, const SceneryShapes& shapes,
                                                const std::string& place);

} // namespace scenery
