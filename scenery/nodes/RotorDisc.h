// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Node>

#include "scenery/models/entities/EntityModel.h"

namespace scenery
{

/// Makes what the eye keeps of blades that turn fast: a thin disc about the hub, a little darker towards its
/// rim, seen from both sides. Frame: the entity's. Needs the uniforms of an Atmosphere above it in the graph.
osg::ref_ptr<osg::Node> makeRotorDisc(const models::EntityRotor& rotor);

/// Whether a rotor turns so fast that the disc is seen in place of its blades.
inline bool isBlurred(double rotorRadps)
{
    constexpr double kBlurRadps = 20.0; // a third of a turn between two frames
    return rotorRadps > kBlurRadps;
}

} // namespace scenery
