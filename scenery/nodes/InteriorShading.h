// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Node>
#include <osg/Program>

#include "scenery/models/cockpit/InteriorModel.h"

namespace scenery
{

/// The program of what is inside a vehicle: sun and sky by shares, and the light of lamps there.
osg::ref_ptr<osg::Program> makeInteriorProgram();

/// The program of a mirror, which shows texture unit 0.
osg::ref_ptr<osg::Program> makeMirrorProgram();

/// The light of the instruments' lamps by night. Linear.
inline constexpr float kPanelLight[3] = {0.75F, 0.52F, 0.33F};

/// Shades what is below `node`, which makeModelNode() has made, as its coat asks for; `outside` stays as it
/// is. Its uniform "interiorLamp" is the light of its own lamps. Needs the uniforms of an Atmosphere above it
/// in the graph.
void setInteriorShading(osg::Node& node, models::InteriorCoat coat);

} // namespace scenery
