// SPDX-License-Identifier: Apache-2.0
#include "DrawnState.h"

#include <osg/LightModel>

namespace osgPMObjects
{

osg::ref_ptr<osg::StateSet> drawnState(const core::Material& material,
                                       std::span<const osg::ref_ptr<osg::StateSet>> states)
{
    if (material.state >= states.size()) return nullptr;
    const osg::ref_ptr<osg::StateSet>& state = states[material.state];
    if (!material.isTwoSided || !state || !(state->getMode(GL_CULL_FACE) & osg::StateAttribute::ON))
        return state;
    osg::ref_ptr<osg::StateSet> both = new osg::StateSet(*state);
    both->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    const osg::ref_ptr<osg::LightModel> lighting = new osg::LightModel;
    lighting->setTwoSided(true);
    both->setAttributeAndModes(lighting);
    return both;
}

} // namespace osgPMObjects
