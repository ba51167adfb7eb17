// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>

#include <osgPMObjects/ProgressiveShape>

namespace osgPMObjects
{

/// How the faces of one level and group are drawn while the level changes or the object fades.
struct Look
{
    float doorFrom = 0.0f, doorTo = 1.0f; ///< the pixels of the screen door that show it
    float alpha = 1.0f;                   ///< blended with the background if below 1 or isBlended
    float morph = 0.0f;
    std::uint32_t firstMorphing = 0;
    bool isMorphing = false;
    bool isBlended = false;

    bool hasDoor() const { return doorFrom > 0.0f || doorTo < 1.0f; }
    bool isPlain() const { return !hasDoor() && !isBlended && !isMorphing; }
    bool isDrawn() const { return doorFrom < doorTo && alpha > 0.0f; }
};

/// What a pass over blended faces writes. The first pass writes only the nearest depth, so that the second
/// blends only the nearest faces with the background, and never faces with each other.
enum class LookPass
{
    all,
    depth,
    colour,
};

/// Sets how a pass tests and writes depth and colours; the caller chooses the bin. `protection`: OSG's
/// override values. The pass `all` is not allowed, as it leaves these to the state around it.
void setPass(osg::StateSet& state, LookPass pass,
             osg::StateAttribute::OverrideValue protection = osg::StateAttribute::OFF);

/// Makes the state of a look, to be pushed below that of the group. It is made for each frame, as the frame
/// before may still be drawn. The pass `all` leaves blending to the group's state.
osg::ref_ptr<osg::StateSet> lookState(const Look& look, LookPass pass, const ProgressiveShape::Group& group);

} // namespace osgPMObjects
