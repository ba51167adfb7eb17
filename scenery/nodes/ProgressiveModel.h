// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/mat3x3.hpp>

#include <osg/Quat>

#include <osgPMObjects/ProgressiveShape>

#include "scenery/models/Model.h"

namespace foundation
{
class KeptResults;
}

namespace scenery
{

/// Simplifies a mesh and arranges it for a field, or finds the same levels among the kept ones.
osgPMObjects::core::ProgressiveMesh progressiveOf(osgPMObjects::core::Mesh mesh,
                                                  const foundation::KeptResults& kept);

/// The same with those of the user.
osgPMObjects::core::ProgressiveMesh progressiveOf(osgPMObjects::core::Mesh mesh);

/// Makes a shape for fields, with what they draw it by, or finds both among the kept ones.
osg::ref_ptr<const osgPMObjects::ProgressiveShape>
fieldShapeOf(osgPMObjects::core::Mesh mesh, std::vector<osg::ref_ptr<osg::StateSet>> states,
             const foundation::KeptResults& kept);

/// Makes generated models progressive, in their order, several at once. They share their textures.
/// Anisotropic filtering is off: it made a frame of some thousand trees take ten times as long on llvmpipe.
std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>>
makeProgressiveModels(std::vector<models::Model> models);

/// Returns the attitude of axes, the columns of a rotation.
osg::Quat attitudeOf(const glm::dmat3& axes);

} // namespace scenery
