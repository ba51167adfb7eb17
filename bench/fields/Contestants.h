// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Group>

#include "Wood.h"

namespace fieldbench
{

using Shapes = std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>>;

/// Our contestant: one field, selected by the area of the bounding sphere on the screen; each visible face is
/// to cover a number of pixels.
osg::ref_ptr<osg::Node> progressiveField(const Shapes& shapes,
                                         const std::vector<osgPMObjects::FieldInstance>& instances,
                                         double trianglePx);

/// The contestant of OpenSceneGraph: a transform for each instance and below it an osg::LOD of five discrete
/// levels, shared by all instances of a kind, with 100, 40, 16, 6 and 2 % of the faces in a cache-friendly
/// order. The distances of the levels follow the same rule.
osg::ref_ptr<osg::Node> discreteLods(const Shapes& shapes,
                                     const std::vector<osgPMObjects::FieldInstance>& instances,
                                     double trianglePx, double pixelsPerTangent);

/// The contestant in full detail: a transform for each instance, and the whole model below it.
osg::ref_ptr<osg::Node> fullDetail(const Shapes& shapes,
                                   const std::vector<osgPMObjects::FieldInstance>& instances);

} // namespace fieldbench
