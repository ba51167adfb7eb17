// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <foundation/Result.h>

#include <osg/ref_ptr>

#include <osgPMObjects/ProgressiveShape>

#include "scenery/placement/Measures.h"
#include "scenery/placement/SceneryDescription.h"

namespace scenery
{

/// A scenery's objects as they are drawn, in the order of scenery::objectsOf().
struct SceneryShapes
{
    std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>> shapes;
    std::vector<Measures> measures;
    std::vector<double> groundZM; ///< where in the model the ground is
    double seconds = 0.0;         ///< they took to make
};

/// Generates or reads all objects and makes them progressive, each in one thread, as many at once as there are processors.
/// The levels depend on the objects alone. A file may hold any model that OpenSceneGraph reads; `.pm` files have their levels
/// already. Its lowest point stands on the ground, upright, z up.
/// Errors: a file that cannot be read, or without surfaces. Cost: 0.3 to 1 s a generated object and thread.
foundation::Result<SceneryShapes> makeSceneryShapes(const std::vector<SceneryObject>& objects);

} // namespace scenery
