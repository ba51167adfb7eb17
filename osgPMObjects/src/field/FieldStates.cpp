// SPDX-License-Identifier: Apache-2.0
#include "FieldStates.h"

#include <initializer_list>

#include <osgPMObjects/ObjectShader>

#include "../progressive/LookState.h"

namespace osgPMObjects
{

namespace
{

constexpr int kDepthBin = 9, kColourBin = 10; // that of OSG's transparent things

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
    for (const LookPass pass : {LookPass::depth, LookPass::colour})
    {
        const osg::ref_ptr<osg::StateSet> state =
            stateWith({kInstancedDefine, kSwitchedDefine, kBlendedDefine});
        setPass(*state, pass, kWins);
        const bool isDepth = pass == LookPass::depth;
        state->setRenderBinDetails(isDepth ? kDepthBin : kColourBin, isDepth ? "RenderBin" : "DepthSortedBin",
                                   osg::StateSet::OVERRIDE_PROTECTED_RENDERBIN_DETAILS);
        (isDepth ? states.blendedDepth : states.blendedColour) = state;
    }
    return states;
}

} // namespace

const FieldStates& FieldStates::shared()
{
    static const FieldStates states = made();
    return states;
}

} // namespace osgPMObjects
