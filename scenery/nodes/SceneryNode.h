// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osg/Group>

#include <osgPMObjects/ProgressiveField>

#include "scenery/nodes/SceneryShapes.h"
#include "scenery/placement/PlaceScenery.h"

namespace scenery
{

/// All objects of a scenery as one field, below a group that shades the objects without a shader of their
/// own. A kind of the field is a pair of a field and an object of the description, because each field has its
/// own settings.
/// Frame: the scene's. Needs the uniforms of an Atmosphere above it in the graph.
struct SceneryNode
{
    osg::ref_ptr<osg::Group> root;
    osg::ref_ptr<osgPMObjects::ProgressiveField> field;
};

/// Makes the node of placed objects (PlacedScenery::placements). Errors, with `place` and the name of the
/// field: selection rules that do not suit the levels of an object; as ProgressiveField::setContents().
foundation::Result<SceneryNode> makeSceneryNode(const SceneryDescription& description,
                                                std::vector<Placement> placements,
                                                const SceneryShapes& shapes, const std::string& place);

} // namespace scenery
