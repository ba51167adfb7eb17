// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgViewer/View>

namespace trainer
{

/// The time of the traversals of all cameras of a view in one frame, summed. Units: milliseconds.
/// The draw traversal hands work to OpenGL; a software rasteriser does much of it later, when the image is
/// read back.
struct CameraTimings
{
    double cullMs = 0.0;
    double drawMs = 0.0;
};

/// Makes the viewer record its times. Call it once when all cameras exist.
void keepCameraTimings(osgViewer::View& view);

/// Returns the times of a drawn frame; 0 when the viewer no longer has them.
CameraTimings cameraTimings(osgViewer::View& view, unsigned int frameNumber);

} // namespace trainer
