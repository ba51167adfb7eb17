// SPDX-License-Identifier: Apache-2.0
#include "FixedFunction.h"

#include <array>

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

int fogModeOf(const osg::State& state)
{
    if (!state.getLastAppliedMode(GL_FOG)) return 0;
    const auto* fog =
        dynamic_cast<const osg::Fog*>(state.getLastAppliedAttribute(osg::StateAttribute::FOG, 0));
    if (!fog) return 0;
    return fog->getMode() == osg::Fog::LINEAR ? 1 : fog->getMode() == osg::Fog::EXP ? 2 : 3;
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
