// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/RoadThingsNode.h"

#include <cmath>
#include <numbers>

#include <osg/Geode>
#include <osg/MatrixTransform>
#include <osg/Program>

#include <osgPMObjects/ObjectShader>
#include <osgTerrainROAM/Atmosphere>
#include <shaders/scenery.h>

#include "scenery/nodes/ModelStates.h"
#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/ProgressiveModel.h"

namespace scenery
{

namespace
{

using osgPMObjects::FieldInstance;
using osgPMObjects::FieldKind;

constexpr int kLampSides = 12;
constexpr double kLampAheadM = 0.01; ///< of the dark lens

/// Returns the light of a lamp, linear: about that of a white wall in the sun.
osg::Vec4f lightOf(models::SignFace face)
{
    if (face == models::SignFace::lampRed) return {1.1F, 0.05F, 0.03F, 1.0F};
    if (face == models::SignFace::lampAmber) return {1.1F, 0.55F, 0.02F, 1.0F};
    return {0.05F, 0.9F, 0.45F, 1.0F};
}

bool shines(models::SignFace face, bool hasAmber, LightState state)
{
    if (state == LightState::off) return false;
    if (face == models::SignFace::lampGreen) return state == LightState::go;
    if (face == models::SignFace::lampAmber)
        return state == LightState::attention || state == LightState::caution;
    return hasAmber ? state == LightState::stop || state == LightState::attention : state != LightState::go;
}

FieldInstance instanceOf(const roads::StandingThing& thing, std::size_t kind)
{
    FieldInstance instance;
    instance.kind = static_cast<std::uint32_t>(kind);
    instance.position.set(thing.position.x, thing.position.y, thing.position.z);
    instance.attitude = attitudeOf(thing.axes);
    instance.scale = thing.scale;
    return instance;
}

} // namespace

osg::ref_ptr<osg::Program> makeRoadLampProgram()
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("road lamp");
    const std::string version = "#version 130\n";
    program->addShader(new osg::Shader(osg::Shader::VERTEX, version + osgPMObjects::glslVertexFunctions() +
                                                                shaders::kObjectVertexMain));
    program->addShader(
        new osg::Shader(osg::Shader::FRAGMENT,
                        version + osgTerrainROAM::Atmosphere::glslFunctions() + shaders::kRoadLampMain));
    osgPMObjects::bindObjectAttributes(*program);
    return program;
}

foundation::Result<std::unique_ptr<RoadThingsNode>> RoadThingsNode::create(const roads::RoadThings& things)
{
    std::unique_ptr<RoadThingsNode> made(new RoadThingsNode);
    ModelStates states;
    std::vector<FieldKind> kinds;
    std::vector<FieldInstance> instances;
    for (const models::RoadModel& model : things.models)
        kinds.push_back({makeProgressiveModel(models::makeRoadModel(model), states)});
    for (const roads::StandingThing& thing : things.standing)
        instances.push_back(instanceOf(thing, thing.model));
    const std::size_t firstGrown = kinds.size();
    for (const roads::GrownModel& grown : things.grown)
        kinds.push_back({makeProgressiveModel(models::generate(grown.kind, grown.seed), states)});
    for (const roads::StandingThing& plant : things.plants)
        instances.push_back(instanceOf(plant, firstGrown + plant.model));
    for (const roads::OwnThing& own : things.own)
    {
        roads::StandingThing thing;
        thing.position = own.origin;
        instances.push_back(instanceOf(thing, kinds.size()));
        kinds.push_back({makeProgressiveModel(own.model, states)});
    }
    made->_root = new osg::Group;
    made->_field = new osgPMObjects::ProgressiveField;
    setObjectShading(*made->_root, Finish::matt);
    if (const auto set = made->_field->setContents(std::move(kinds), instances); !set) return set.error();
    made->_root->addChild(made->_field);
    made->addLamps(things);
    return made;
}

void RoadThingsNode::addLamps(const roads::RoadThings& things)
{
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array;
    glm::dvec3 origin(0.0);
    for (const roads::StandingThing& thing : things.standing)
    {
        const auto lenses = models::lensesOf(things.models[thing.model]);
        if (lenses.empty()) continue;
        if (_lights.empty()) origin = thing.position;
        Lamps lamps{corners->size(), {}};
        for (const models::Lens& lens : lenses)
        {
            lamps.faces.push_back(lens.face);
            const auto at = [&](int i)
            {
                const double turn = -2.0 * std::numbers::pi * i / kLampSides;
                const glm::dvec3 inModel =
                    lens.middle + glm::dvec3(-kLampAheadM, 0.95 * lens.radiusM * std::cos(turn),
                                             0.95 * lens.radiusM * std::sin(turn));
                const glm::dvec3 p = thing.position - origin + thing.axes * inModel;
                return osg::Vec3f(osg::Vec3d(p.x, p.y, p.z));
            };
            for (int i = 1; i + 1 < kLampSides; ++i)
                for (const int k : {0, i, i + 1})
                    corners->push_back(at(k));
            const glm::dvec3 towards = -thing.axes[0];
            normals->resize(corners->size(), osg::Vec3f(osg::Vec3d(towards.x, towards.y, towards.z)));
        }
        _lights.emplace(thing.signalId, lamps);
    }
    if (_lights.empty()) return;
    _lamps = new osg::Geometry;
    _lamps->setDataVariance(osg::Object::DYNAMIC);
    _lamps->setUseDisplayList(false);
    _lamps->setUseVertexBufferObjects(true);
    _lamps->setVertexArray(corners);
    _lamps->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    _lamps->setColorArray(new osg::Vec4Array(static_cast<unsigned>(corners->size())),
                          osg::Array::BIND_PER_VERTEX);
    _lamps->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners->size())));
    const osg::ref_ptr<osg::MatrixTransform> placed =
        new osg::MatrixTransform(osg::Matrixd::translate(origin.x, origin.y, origin.z));
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(_lamps);
    placed->addChild(geode);
    placed->getOrCreateStateSet()->setAttributeAndModes(makeRoadLampProgram());
    _root->addChild(placed);
    for (auto light = _lights.begin(); light != _lights.end(); light = _lights.upper_bound(light->first))
        setState(light->first, LightState::stop);
}

bool RoadThingsNode::setState(const std::string& signalId, LightState state)
{
    const auto [first, last] = _lights.equal_range(signalId);
    if (first == last) return false;
    auto& colours = static_cast<osg::Vec4Array&>(*_lamps->getColorArray());
    for (auto light = first; light != last; ++light)
    {
        std::size_t at = light->second.first;
        const std::vector<models::SignFace>& faces = light->second.faces;
        for (const models::SignFace face : faces)
            for (int i = 0; i < 3 * (kLampSides - 2); ++i)
                colours[at++] = shines(face, faces.size() > 2, state) ? lightOf(face)
                                                                      : osg::Vec4f(0.0F, 0.0F, 0.0F, 0.0F);
    }
    colours.dirty();
    return true;
}

bool RoadThingsNode::setState(const std::string& signalId, const std::string& state)
{
    static const std::map<std::string, LightState> kWords{
        {"off", LightState::off},         {"stop", LightState::stop},
        {"red", LightState::stop},        {"attention", LightState::attention},
        {"go", LightState::go},           {"green", LightState::go},
        {"caution", LightState::caution}, {"yellow", LightState::caution},
        {"amber", LightState::caution}};
    const auto word = kWords.find(state);
    return word != kWords.end() && setState(signalId, word->second);
}

} // namespace scenery
