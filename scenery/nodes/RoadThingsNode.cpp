// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/RoadThingsNode.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include <osgSky/SunShadows>

#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/ProgressiveModel.h"

namespace scenery
{

namespace
{

using osgPMObjects::FieldInstance;
using osgPMObjects::FieldKind;

constexpr double kSlenderM = 2.5; ///< height of what casts into the nearest shadow maps alone

FieldInstance instanceOf(const roads::StandingThing& thing, std::size_t kind)
{
    FieldInstance instance;
    instance.kind = static_cast<std::uint32_t>(kind);
    instance.position.set(thing.position.x, thing.position.y, thing.position.z);
    instance.attitude = attitudeOf(thing.axes);
    instance.scale = thing.scale;
    return instance;
}

struct Contents
{
    std::vector<models::Model> models;
    std::vector<FieldInstance> instances;
};

foundation::Result<osg::ref_ptr<osgPMObjects::ProgressiveField>> fieldOf(Contents contents)
{
    std::vector<FieldKind> kinds;
    for (const auto& shape : makeProgressiveModels(std::move(contents.models)))
        kinds.push_back({shape});
    osg::ref_ptr<osgPMObjects::ProgressiveField> field = new osgPMObjects::ProgressiveField;
    if (const auto set = field->setContents(std::move(kinds), std::move(contents.instances)); !set)
        return set.error();
    return field;
}

/// Whether a model is a rail or a fence: long, and no higher than a person.
bool isSlender(const models::Model& model)
{
    double low = 1e300, high = -1e300;
    for (const auto& position : model.mesh.positions)
    {
        low = std::min(low, static_cast<double>(position.z));
        high = std::max(high, static_cast<double>(position.z));
    }
    return high - low < kSlenderM;
}

/// Reads `on;off;off`; nothing when the text is not such a list.
std::optional<std::vector<bool>> lensesOf(const std::string& state)
{
    if (state.find(';') == std::string::npos) return std::nullopt;
    std::vector<bool> lit;
    std::istringstream words(state);
    for (std::string word; std::getline(words, word, ';');)
    {
        if (word != "on" && word != "off" && word != "flashing") return std::nullopt;
        lit.push_back(word != "off");
    }
    return lit;
}

} // namespace

foundation::Result<std::unique_ptr<RoadThingsNode>> RoadThingsNode::create(const roads::RoadThings& things)
{
    std::unique_ptr<RoadThingsNode> made(new RoadThingsNode);
    Contents others;
    auto& [models, instances] = others;
    for (const models::RoadModel& model : things.models)
        models.push_back(models::makeRoadModel(model));
    for (const roads::StandingThing& thing : things.standing)
        instances.push_back(instanceOf(thing, thing.model));
    const std::size_t firstGrown = models.size();
    for (const roads::GrownModel& grown : things.grown)
        models.push_back(models::generate(grown.kind, grown.seed));
    for (const roads::StandingThing& plant : things.plants)
        instances.push_back(instanceOf(plant, firstGrown + plant.model));
    Contents slender;
    for (const roads::OwnThing& own : things.own)
    {
        roads::StandingThing thing;
        thing.position = own.origin;
        Contents& contents = isSlender(own.model) ? slender : others;
        contents.instances.push_back(instanceOf(thing, contents.models.size()));
        contents.models.push_back(own.model);
    }
    made->_root = new osg::Group;
    setObjectShading(*made->_root, Finish::matt);
    for (Contents* const contents : {&others, &slender})
    {
        auto field = fieldOf(std::move(*contents));
        if (!field) return field.error();
        if (contents == &slender) (*field)->setNodeMask(osgSky::SunShadows::kSlender);
        made->_root->addChild(*field);
        made->_fields.push_back(std::move(*field));
    }
    made->_lamps = std::make_unique<RoadLamps>(things);
    if (made->_lamps->node()) made->_root->addChild(made->_lamps->node());
    return made;
}

bool RoadThingsNode::setState(const std::string& signalId, const std::string& state)
{
    static const std::map<std::string, LightState> kWords{
        {"off", LightState::off},         {"stop", LightState::stop},
        {"red", LightState::stop},        {"attention", LightState::attention},
        {"go", LightState::go},           {"green", LightState::go},
        {"caution", LightState::caution}, {"yellow", LightState::caution},
        {"amber", LightState::caution}};
    if (const auto lenses = lensesOf(state)) return _lamps->setLenses(signalId, *lenses);
    const auto word = kWords.find(state);
    return word != kWords.end() && setState(signalId, word->second);
}

} // namespace scenery
