// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Node>
#include <osg/Vec2f>

namespace scenery
{

/// Makes a soft dark patch on the ground below a body, where the body hides the sky. It does not depend on
/// the sun. It lies slightly above the plane z = 0 of the body and is drawn with a polygon offset, so that
/// terrain within some centimetres of that plane does not hide it.
/// Frame: the body's. Units: metres. `middle`: the middle of the dark core, then half its length and half its
/// width; the rim fades over half a metre.
osg::ref_ptr<osg::Node> makeContactShadow(const osg::Vec2f& middle, float halfLengthM, float halfWidthM);

} // namespace scenery
