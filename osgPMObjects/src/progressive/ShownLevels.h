// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgUtil/CullVisitor>

#include "GroupLevels.h"
#include "LookState.h"

namespace osgPMObjects
{

/// What one camera shows of an object.
struct ShownLevels
{
    core::DrawnLevels drawn;          ///< without the alpha range
    GroupLevels::Parts first, second; ///< of those levels; `second` only while two are drawn
    float alpha = 1.0f;               ///< of the alpha range
    float finerShare = 1.0f;          ///< the share of the finer level in a blend
    bool isMorphing = false;
    std::uint32_t firstMorphing = 0; ///< the first vertex that moves
    bool byDoor = false;             ///< a screen door instead of alpha blending

    bool isBlend() const { return drawn.second.alpha > 0.0f; }

    /// Returns how a group of one of the two levels is drawn. The finer level's pixels come first in the
    /// pattern of the screen door, so the pattern stays when a switch runs back. A transparent group is
    /// blended by screen door, as two transparent layers differ from one.
    Look lookOf(bool isSecond, bool isTransparent) const;
};

/// Puts the levels into the render graph, below the states of the groups, in drawing order. `isShaded`: with
/// the program of the shape, where neither the group nor a node above has one.
void cullLevels(osgUtil::CullVisitor& visitor, const ProgressiveShape& shape, const ShownLevels& shown,
                bool isShaded);

} // namespace osgPMObjects
