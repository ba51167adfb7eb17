// SPDX-License-Identifier: Apache-2.0
#include "LookState.h"

#include <cassert>

#include <osg/AlphaFunc>
#include <osg/BlendFunc>
#include <osg/ColorMask>
#include <osg/Depth>

#include <osgPMObjects/ObjectShader>

namespace osgPMObjects
{

namespace
{

/// The bin of OSG's transparent objects.
constexpr int kTransparentBin = 10;

osg::Vec4 shownOf(const Look& look)
{
    const float from = look.isBlended ? 0.0F : look.doorFrom, to = look.isBlended ? look.alpha : look.doorTo;
    return {from, to, look.morph, static_cast<float>(look.firstMorphing)};
}

/// Scales the reference of an alpha test with alpha, so that the holes that it cuts stay the same.
void scaleAlphaTest(osg::StateSet& state, float alpha, const osg::StateSet* group)
{
    if (!group || !(group->getMode(GL_ALPHA_TEST) & osg::StateAttribute::ON)) return;
    const auto* const test =
        dynamic_cast<const osg::AlphaFunc*>(group->getAttribute(osg::StateAttribute::ALPHAFUNC));
    if (test) state.setAttribute(new osg::AlphaFunc(test->getFunction(), test->getReferenceValue() * alpha));
}

} // namespace

void setPass(osg::StateSet& state, LookPass pass, osg::StateAttribute::OverrideValue protection)
{
    assert(pass != LookPass::all);
    const bool isDepth = pass == LookPass::depth;
    const osg::StateAttribute::GLModeValue mode = osg::StateAttribute::ON | protection;
    state.setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, isDepth), mode);
    if (isDepth)
        state.setAttribute(new osg::ColorMask(false, false, false, false), protection);
    else
        state.setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), mode);
}

osg::ref_ptr<osg::StateSet> lookState(const Look& look, LookPass pass, const ProgressiveShape::Group& group)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setDefine(kSwitchedDefine);
    if (look.isMorphing) state->setDefine(kMorphDefine);
    state->addUniform(new osg::Uniform(kShownUniform, shownOf(look)));
    if (!look.isBlended) return state;
    state->setDefine(kBlendedDefine);
    scaleAlphaTest(*state, look.alpha, group.state);
    if (pass == LookPass::all) return state;
    setPass(*state, pass);
    state->setRenderBinDetails(kTransparentBin, "DepthSortedBin");
    return state;
}

} // namespace osgPMObjects
