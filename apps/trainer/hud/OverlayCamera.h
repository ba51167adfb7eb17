// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Camera>
#include <osgText/Text>

namespace trainer
{

/// A camera for things drawn over the picture in pixels from the lower left corner. `order`: higher ones draw
/// later.
osg::ref_ptr<osg::Camera> makeOverlayCamera(int order);

/// Gives such a camera the size of the picture. Units: pixels.
void fitOverlay(osg::Camera& camera, int widthPx, int heightPx);

/// White text with a dark outline that can be read over anything. Positions and sizes are in pixels.
osg::ref_ptr<osgText::Text> makeOverlayText(osgText::Text::AlignmentType alignment);

/// A translucent dark rectangle of unit size.
osg::ref_ptr<osg::Geometry> makeUnitPanel(const osg::Vec4& colour);

} // namespace trainer
