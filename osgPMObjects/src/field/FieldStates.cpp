// SPDX-License-Identifier: Apache-2.0
#include "FieldStates.h"

#include <initializer_list>

#include <osg/BlendFunc>
#include <osg/ColorMask>
#include <osg/Depth>

#include <osgPMObjects/ObjectShader>

namespace osgPMObjects
{

namespace
{

constexpr int kDepthBin = 9; // OSG's transparent things are in bin 10

osg::ref_ptr<osg::StateSet> stateWith(std::initializer_list<const char*> defines)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    for (const char* const define : defines)
        state->setDefine(define);
    return state;
}

FieldStates made()
{
    FieldStates states;
    states.settled = stateWith({kInstancedDefine});
    states.screenDoor = stateWith({kInstancedDefine, kSwitchedDefine});
    states.morphing = stateWith({kInstancedDefine, kSwitchedDefine, kMorphDefine});
    states.leaves = stateWith({kLeavesDefine});
    constexpr auto kWins = osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;
    states.blendedDepth = stateWith({kInstancedDefine, kSwitchedDefine, kBlendedDefine});
    states.blendedDepth->setAttribute(new osg::ColorMask(false, false, false, false), kWins);
    states.blendedDepth->setRenderBinDetails(kDepthBin, "RenderBin",
                                             osg::StateSet::OVERRIDE_PROTECTED_RENDERBIN_DETAILS);
    states.blendedColour = stateWith({kInstancedDefine, kSwitchedDefine, kBlendedDefine});
    states.blendedColour->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA),
                                               osg::StateAttribute::ON | kWins);
    states.blendedColour->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false),
                                               osg::StateAttribute::ON | kWins);
    states.blendedColour->setRenderBinDetails(10, "DepthSortedBin",
                                              osg::StateSet::OVERRIDE_PROTECTED_RENDERBIN_DETAILS);
    return states;
}

} // namespace

const FieldStates& FieldStates::shared()
{
    static const FieldStates states = made();
    return states;
}

} // namespace osgPMObjects
