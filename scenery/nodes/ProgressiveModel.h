// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>

#include <osg/Quat>

#include <osgPMObjects/ProgressiveShape>

#include "scenery/models/Model.h"
#include "scenery/nodes/ModelStates.h"

namespace scenery
{

/// Simplifies a mesh and arranges it for a field.
osgPMObjects::core::ProgressiveMesh progressiveOf(osgPMObjects::core::Mesh mesh);

/// Makes a generated model progressive. Anisotropic filtering is off: it made a frame of some thousand trees take ten times as long on llvmpipe.
osg::ref_ptr<const osgPMObjects::ProgressiveShape> makeProgressiveModel(const models::Model& model,
                                                                        ModelStates& states);

/// Turns off anisotropic filtering of the textures of states.
void useIsotropicTextures(const std::vector<osg::ref_ptr<osg::StateSet>>& states);

/// Returns the attitude of axes, the columns of a rotation.
osg::Quat attitudeOf(const glm::dmat3& axes);

} // namespace scenery
