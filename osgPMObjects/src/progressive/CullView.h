// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <osg/Camera>
#include <osgUtil/CullVisitor>

#include <osgPMObjects/core/selection/LevelSelector.h>

namespace osgPMObjects
{

/// The view for which a cull traversal draws an object.
/// Frame of `view`: the object's own, in metres of the eye's frame, whatever scales stand above the object.
struct CullView
{
    osg::Camera* camera = nullptr;
    /// The main camera, for a shadow or reflection camera that is nested and relative to it: its levels are
    /// shown.
    const osg::Camera* mainCamera = nullptr;
    unsigned int frame = 0;
    double timeS = 0.0;                    ///< time of the simulation
    std::optional<unsigned int> contextId; ///< the context that will draw; absent: none
    viewlod::ViewState view;
    double lodScale = 1.0;      ///< of OSG; above 1 gives coarser detail
    double metresPerUnit = 1.0; ///< length of the object's unit
    bool isParallel = false;    ///< the projection; then view.pixelsPerTangent counts by the metre
};

CullView cullViewOf(osgUtil::CullVisitor& visitor);

} // namespace osgPMObjects
