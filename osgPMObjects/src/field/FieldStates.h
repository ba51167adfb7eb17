// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>

#include <osgPMObjects/core/field/FieldDrawList.h>

namespace osgPMObjects
{

/// The states that the passes of a field put around those of its materials.
/// A blended pass has two: the nearest surfaces' depth first, of all materials and instances, then their
/// colours; so nothing that is blended is blended with itself. Both come after what is opaque, and before or
/// among what else is transparent.
struct FieldStates
{
    osg::ref_ptr<osg::StateSet> settled, screenDoor, morphing, blendedDepth, blendedColour;
    osg::ref_ptr<osg::StateSet> leaves; ///< around materials whose cards grow

    /// Shared by all fields; made once.
    static const FieldStates& shared();
};

} // namespace osgPMObjects
