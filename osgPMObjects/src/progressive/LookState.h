// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>

#include <osgPMObjects/ProgressiveShape>

namespace osgPMObjects
{

/// How the faces of one level and group are drawn on the way between two levels, or while they fade.
struct Look
{
    float doorFrom = 0.0f, doorTo = 1.0f; ///< which pixels of the door's pattern show it
    float alpha = 1.0f;                   ///< blended with what is behind, if below 1 or isBlended
    float morph = 0.0f;
    std::uint32_t firstMorphing = 0;
    bool isMorphing = false;
    bool isBlended = false;

    bool hasDoor() const { return doorFrom > 0.0f || doorTo < 1.0f; }
    bool isPlain() const { return !hasDoor() && !isBlended && !isMorphing; }
    bool isDrawn() const { return doorFrom < doorTo && alpha > 0.0f; }
};

/// What is written of faces that are blended: first the nearest depth alone, so that then only the nearest faces are blended with what
/// is behind, never with each other.
enum class LookPass
{
    all,
    depth,
    colour,
};

/// How a pass tests and writes depth and colours; `protection`: OSG's override values. In which bin it comes is the caller's.
/// Not of the pass `all`, which leaves that to the state around it.
void setPass(osg::StateSet& state, LookPass pass,
             osg::StateAttribute::OverrideValue protection = osg::StateAttribute::OFF);

/// The state of a look, to be pushed below that of the group. One is made for each frame, as the last frame may still be
/// drawn. The pass `all` leaves blending itself to the group's state.
osg::ref_ptr<osg::StateSet> lookState(const Look& look, LookPass pass, const ProgressiveShape::Group& group);

} // namespace osgPMObjects
