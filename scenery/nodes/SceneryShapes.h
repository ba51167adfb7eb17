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

/// The shapes of the objects of a scenery, in the order of scenery::objectsOf().
struct SceneryShapes
{
    std::vector<osg::ref_ptr<const osgPMObjects::ProgressiveShape>> shapes;
    std::vector<Measures> measures;
    std::vector<double> groundZM; ///< z of the ground in the model
    double seconds = 0.0;         ///< to make them
};

/// Generates or reads all objects and makes them progressive, each in one thread, in as many threads as there
/// are processors. The levels depend on the objects only. A file may hold any model that OpenSceneGraph
/// reads, upright with z up; its lowest point is put on the ground. `.pm` files contain their levels.
/// Errors: a file that cannot be read, or without surfaces. Cost: 0.3 to 1 s a generated object and thread.
foundation::Result<SceneryShapes> makeSceneryShapes(const std::vector<SceneryObject>& objects);

} // namespace scenery
