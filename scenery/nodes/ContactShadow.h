// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Node>
#include <osg/Vec2f>

namespace scenery
{

/// A soft dark patch on the ground under a body, as the sky's light is kept out below it. It does not depend on the
/// sun, lies a little above the plane z = 0 of the body, and is drawn with an offset towards the eye, so that terrain
/// which follows that plane within some centimetres does not swallow it.
/// Frame: the body's. Units: metres; `middle` of the dark core, half its length and half its width; the rim fades
/// over half a metre.
osg::ref_ptr<osg::Node> makeContactShadow(const osg::Vec2f& middle, float halfLengthM, float halfWidthM);

} // namespace scenery
