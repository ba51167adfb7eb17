// SPDX-License-Identifier: Apache-2.0
#include "FixedFunction.h"

#include <array>
#include <numbers>

#include <osg/Array>
#include <osg/Fog>

namespace osgTerrainROAM
{

int lightsOf(const osg::State& state)
{
    if (!state.getLastAppliedMode(GL_LIGHTING)) return -1;
    int lights = 0;
    for (unsigned int light = 0; light < 8; ++light)
        if (state.getLastAppliedMode(GL_LIGHT0 + light)) lights |= 1 << light;
    return lights;
}

osg::Vec4f fogOf(const osg::State& state)
{
    const osg::Vec4f none(1.0f, 0.0f, 0.0f, 0.0f);
    if (!state.getLastAppliedMode(GL_FOG)) return none;
    const auto* fog =
        dynamic_cast<const osg::Fog*>(state.getLastAppliedAttribute(osg::StateAttribute::FOG, 0));
    if (!fog) return none;
    const float perExp = 1.0f / std::numbers::ln2_v<float>;
    const float density = fog->getDensity(), range = fog->getEnd() - fog->getStart();
    if (fog->getMode() == osg::Fog::EXP) return {1.0f, 0.0f, density * perExp, 0.0f};
    if (fog->getMode() == osg::Fog::EXP2) return {1.0f, 0.0f, 0.0f, density * density * perExp};
    return range == 0.0f ? none : osg::Vec4f(fog->getEnd() / range, -1.0f / range, 0.0f, 0.0f);
}

void setColourWhite(osg::State& state)
{
    static const osg::ref_ptr<osg::Vec4Array> white =
        new osg::Vec4Array(1, std::array{osg::Vec4(1, 1, 1, 1)}.data());
    osg::AttributeDispatchers& dispatchers = state.getAttributeDispatchers();
    dispatchers.reset();
    if (osg::AttributeDispatch* colour = dispatchers.colorDispatcher(white)) (*colour)(0);
}

} // namespace osgTerrainROAM
