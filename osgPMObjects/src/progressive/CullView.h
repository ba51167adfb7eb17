// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <osg/Camera>
#include <osgUtil/CullVisitor>

#include <osgPMObjects/core/selection/LevelSelector.h>

namespace osgPMObjects
{

/// What one cull traversal knows when it comes to an object.
/// Frame of `view`: the object's own, scaled to the length unit of the eye, so that distances are in metres whatever scales stand above.
struct CullView
{
    osg::Camera* camera = nullptr;
    /// Of a shadow or reflection camera, nested and relative to it: whose levels it shows.
    const osg::Camera* mainCamera = nullptr;
    unsigned int frame = 0;
    double timeS = 0.0;                    ///< of the simulation
    std::optional<unsigned int> contextId; ///< who will draw; absent: nobody
    viewlod::ViewState view;
    double lodScale = 1.0;      ///< OSG's own knob for coarser (> 1) or finer detail
    double metresPerUnit = 1.0; ///< of the object's frame
};

CullView cullViewOf(osgUtil::CullVisitor& visitor);

} // namespace osgPMObjects
