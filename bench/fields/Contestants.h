// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Group>

#include "Wood.h"

namespace fieldbench
{

using Shapes = std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>>;

/// Ours: one field, by the area of the sphere in the picture, of which a face that is seen shall cover so many pixels.
osg::ref_ptr<osg::Node> progressiveField(const Shapes& shapes,
                                         const std::vector<osgPMObjects::FieldInstance>& instances,
                                         double trianglePx);

/// What OpenSceneGraph has for it: a transform for each instance, below it an osg::LOD of five discrete levels that all instances
/// of a kind share, of 100, 40, 16, 6 and 2 % of the faces, in the order that serves a cache best. A level is drawn from where
/// the same rule asks for no more of the faces.
osg::ref_ptr<osg::Node> discreteLods(const Shapes& shapes,
                                     const std::vector<osgPMObjects::FieldInstance>& instances,
                                     double trianglePx, double pixelsPerTangent);

/// A transform for each instance, and the whole model below it.
osg::ref_ptr<osg::Node> fullDetail(const Shapes& shapes,
                                   const std::vector<osgPMObjects::FieldInstance>& instances);

} // namespace fieldbench
