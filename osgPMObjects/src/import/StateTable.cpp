// SPDX-License-Identifier: Apache-2.0
#include "StateTable.h"

#include <tuple>

#include <osg/LightModel>
#include <osg/Material>

namespace osgPMObjects
{

namespace
{

using core::Material;

bool isOn(osg::StateAttribute::GLModeValue value)
{
    return (value & osg::StateAttribute::ON) != 0;
}

bool isTextured(const osg::StateSet& state, unsigned unit)
{
    const auto& modes = state.getTextureModeList();
    if (unit >= modes.size()) return false;
    for (const auto& [mode, value] : modes[unit])
        if (isOn(value)) return true;
    return false;
}

/// Returns the attributes that a state without shaders does not use; with shaders all may be used.
/// Lighting that is not set counts as on, as osgViewer sets it initially.
std::uint32_t unseenBy(const osg::StateSet& state)
{
    if (state.getAttribute(osg::StateAttribute::PROGRAM)) return 0;
    std::uint32_t unseen = 0;
    if (!isTextured(state, 0)) unseen |= Material::texCoord0;
    if (!isTextured(state, 1)) unseen |= Material::texCoord1;
    const auto lighting = state.getMode(GL_LIGHTING);
    const bool isLit = lighting == osg::StateAttribute::INHERIT || isOn(lighting);
    const auto* material =
        dynamic_cast<const osg::Material*>(state.getAttribute(osg::StateAttribute::MATERIAL));
    if (!isLit) unseen |= Material::normal;
    if (isLit && material && material->getColorMode() == osg::Material::OFF) unseen |= Material::colour;
    return unseen;
}

std::string nameOf(const osg::StateSet& state)
{
    if (!state.getName().empty()) return state.getName();
    const osg::StateAttribute* material = state.getAttribute(osg::StateAttribute::MATERIAL);
    return material ? material->getName() : std::string();
}

} // namespace

osg::ref_ptr<osg::StateSet> StateTable::below(const osg::ref_ptr<osg::StateSet>& above, osg::StateSet* own)
{
    if (!own) return above;
    osg::ref_ptr<osg::StateSet>& known = _merged[{above, own}];
    if (known) return known;
    known = above ? new osg::StateSet(*above) : new osg::StateSet;
    known->merge(*own);
    if (own->getRenderBinMode() != osg::StateSet::INHERIT_RENDERBIN_DETAILS)
    {
        known->setRenderingHint(own->getRenderingHint());
        known->setRenderBinDetails(own->getBinNumber(), own->getBinName(), own->getRenderBinMode());
    }
    known->setName(own->getName());
    return known;
}

bool StateTable::LessByContent::operator()(const osg::StateSet* a, const osg::StateSet* b) const
{
    const auto bin = [](const osg::StateSet* s)
    {
        return std::tuple(s->getRenderBinMode(), s->getBinNumber(), s->getBinName(), s->getRenderingHint(),
                          s->getNestRenderBins());
    };
    if (bin(a) != bin(b)) return bin(a) < bin(b);
    return a->compare(*b, true) < 0;
}

std::uint32_t StateTable::handleOf(const osg::ref_ptr<osg::StateSet>& state)
{
    const auto next = static_cast<std::uint32_t>(_states.size());
    const auto [place, isNew] = _handles.emplace(state.get(), next);
    if (isNew) _states.push_back(state);
    return place->second;
}

core::Material StateTable::materialOf(const osg::ref_ptr<osg::StateSet>& given, std::uint32_t attributes)
{
    const osg::ref_ptr<osg::StateSet> state = given ? given : _nothing;
    core::Material material;
    material.state = handleOf(state);
    material.name = nameOf(*_states[material.state]);
    material.attributes = attributes;
    material.unseen = unseenBy(*state);
    material.isTwoSided = !isOn(state->getMode(GL_CULL_FACE));
    const auto* lighting =
        dynamic_cast<const osg::LightModel*>(state->getAttribute(osg::StateAttribute::LIGHTMODEL));
    material.litFromBothSides = lighting && lighting->getTwoSided();
    material.isTransparent =
        isOn(state->getMode(GL_BLEND)) || state->getRenderingHint() == osg::StateSet::TRANSPARENT_BIN;
    return material;
}

} // namespace osgPMObjects
