// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include <osg/Group>
#include <osg/StateSet>
#include <osg/Texture2D>

#include "scenery/models/Model.h"

namespace scenery
{

/// The states of generated models: one for each surface and one texture for each painting, shared by all
/// models that use the same ModelStates. Textures have mipmaps; those of foliage keep their coverage with
/// distance. A texture is painted when it is first used. Threads: one.
/// Memory: up to 5.3 MB a texture, see docs/guide/generated-models.md.
class ModelStates
{
public:
    osg::ref_ptr<osg::StateSet> stateOf(const models::Surface& surface);

    /// Returns the states by core::Material::state, as exportNode() takes them.
    std::vector<osg::ref_ptr<osg::StateSet>> statesOf(const models::Model& model);

private:
    using Look = std::shared_ptr<const models::VehicleLook>;

    osg::ref_ptr<osg::Texture2D> textureOf(const models::Surface& surface);

    std::map<std::pair<models::Painting, Look>, osg::ref_ptr<osg::Texture2D>> _textures;
    std::map<std::tuple<models::Painting, models::Coat, Look>, osg::ref_ptr<osg::StateSet>> _states;
};

/// Makes the node of a model, in its own frame. Needs the uniforms of an Atmosphere above it in the graph.
osg::ref_ptr<osg::Group> makeModelNode(const models::Model& model, ModelStates& states);

} // namespace scenery
