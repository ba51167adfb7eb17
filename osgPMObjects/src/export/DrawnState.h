// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <osg/StateSet>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects
{

/// The state that a material is drawn with; where the material is seen from both sides and its state is not, a copy with
/// nothing culled, and the backs lit as backs. Null where the material has none among the `states`.
osg::ref_ptr<osg::StateSet> drawnState(const core::Material& material,
                                       std::span<const osg::ref_ptr<osg::StateSet>> states);

} // namespace osgPMObjects
