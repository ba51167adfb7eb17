// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <osg/StateSet>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects
{

/// Returns the state that draws a material. If the material is two-sided and its state is not, this is a copy
/// that culls no side and lights back faces as back faces. Null: the material has none among the `states`.
osg::ref_ptr<osg::StateSet> drawnState(const core::Material& material,
                                       std::span<const osg::ref_ptr<osg::StateSet>> states);

} // namespace osgPMObjects
