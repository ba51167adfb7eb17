// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgUtil/CullVisitor>

#include "GroupLevels.h"
#include "LookState.h"

namespace osgPMObjects
{

/// What one camera is shown of an object.
struct ShownLevels
{
    core::DrawnLevels drawn;          ///< without the alpha range
    GroupLevels::Parts first, second; ///< of those levels; of the second only while two are drawn
    float alpha = 1.0f;               ///< of the alpha range
    float finerShare = 1.0f;          ///< of a blend
    bool isMorphing = false;
    std::uint32_t firstMorphing = 0; ///< vertex
    bool byDoor = false;             ///< a screen door instead of alpha

    bool isBlend() const { return drawn.second.alpha > 0.0f; }

    /// How a group of one of the two is drawn. Doors: the finer level's pixels come first in the pattern, so that they are the same
    /// when a switch runs back. A group that is transparent itself is blended by doors, for two panes are not one.
    Look lookOf(bool isSecond, bool isTransparent) const;
};

/// Puts the levels into the render graph below the groups' states, in the order in which they have to be drawn. `isShaded`: with the
/// shape's program, where neither group nor what is above has one.
void cullLevels(osgUtil::CullVisitor& visitor, const ProgressiveShape& shape, const ShownLevels& shown,
                bool isShaded);

} // namespace osgPMObjects
