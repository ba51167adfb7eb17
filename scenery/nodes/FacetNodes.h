// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include <osg/Geometry>
#include <osg/Group>

#include "scenery/buildings/BuildingFacets.h"

namespace scenery
{

/// Makes a geometry of facets, in their frame.
osg::ref_ptr<osg::Geometry> geometryOf(const Facets& facets);

/// Makes what casts the shadow of facets of several textures: one geometry that shadow maps alone draw, in
/// place of these.
osg::ref_ptr<osg::Geometry> casterOf(const std::map<models::Painting, Facets>& facets);

/// Adds a node below `parent`, at `origin`, whose content is drawn up to `farM`, by ranges that overlap
/// (RangedGroup); returns it.
osg::Group& addOverlapping(osg::Group& parent, const glm::dvec3& origin, double farM);

/// Adds a node below `parent`, at `origin`, whose content is drawn from `nearM` to `farM`; returns it.
osg::Group& addRange(osg::Group& parent, const glm::dvec3& origin, double nearM, double farM);

} // namespace scenery
