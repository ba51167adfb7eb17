// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgViewer/View>

namespace trainer
{

/// How long the traversals of all cameras of a view took in one frame, together. Units: milliseconds.
/// Drawing is the traversal that hands work to GL; with a software rasteriser much of the work itself comes later,
/// when the picture is taken.
struct CameraTimings
{
    double cullMs = 0.0;
    double drawMs = 0.0;
};

/// Makes the viewer keep its times. To be called once, when all cameras are there.
void keepCameraTimings(osgViewer::View& view);

/// Of a frame that has been drawn; 0 for one that is not known (any more).
CameraTimings cameraTimings(osgViewer::View& view, unsigned int frameNumber);

} // namespace trainer
