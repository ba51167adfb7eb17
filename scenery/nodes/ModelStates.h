// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <vector>

#include <osg/Group>
#include <osg/StateSet>
#include <osg/Texture2D>

#include "scenery/models/Model.h"

namespace scenery
{

/// The states that generated models are drawn with: one for each surface, one texture for each painting, shared by all models
/// that are given the same ModelStates. Textures have mip-maps; those of foliage keep their coverage with distance.
/// Paintings are made when they are first asked for. Threads: one.
/// Memory: up to 5.3 MB a painting, see docs/guide/generated-models.md.
class ModelStates
{
public:
    osg::ref_ptr<osg::StateSet> stateOf(const models::Surface& surface);

    /// By core::Material::state, as exportNode() wants them.
    std::vector<osg::ref_ptr<osg::StateSet>> statesOf(const models::Model& model);

private:
    osg::ref_ptr<osg::Texture2D> textureOf(models::Painting painting, bool isFoliage);

    std::array<osg::ref_ptr<osg::Texture2D>, static_cast<std::size_t>(models::Painting::count)> _textures;
    std::map<std::pair<models::Painting, models::Coat>, osg::ref_ptr<osg::StateSet>> _states;
};

/// A model as a node, in its own frame. Lit and hazed by the Atmosphere whose uniforms stand above it.
osg::ref_ptr<osg::Group> makeModelNode(const models::Model& model, ModelStates& states);

} // namespace scenery
