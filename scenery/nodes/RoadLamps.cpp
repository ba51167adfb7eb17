// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/RoadLamps.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include <osg/Geode>

#include <osgPMObjects/ObjectShader>
#include <osgTerrainROAM/Atmosphere>
#include <shaders/scenery.h>

namespace scenery
{

namespace
{

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

/// The light of the lamps of tunnels.
const osg::Vec4f kCeilingLight(1.3F, 1.22F, 1.0F, 1.0F);

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

RoadLamps::RoadLamps(const roads::RoadThings& things)
{
    for (const roads::StandingThing& thing : things.standing)
        if (const auto lenses = models::lensesOf(things.models[thing.model]); !lenses.empty())
            addSignal(thing, lenses);
    for (const roads::CeilingLamp& lamp : things.lamps)
        addCeilingLamp(lamp);
    if (_corners->empty()) return;
    _colours->resize(_corners->size(), kCeilingLight);
    _geometry = new osg::Geometry;
    _geometry->setDataVariance(osg::Object::DYNAMIC);
    _geometry->setUseDisplayList(false);
    _geometry->setUseVertexBufferObjects(true);
    _geometry->setVertexArray(_corners);
    _geometry->setNormalArray(_normals, osg::Array::BIND_PER_VERTEX);
    _geometry->setColorArray(_colours, osg::Array::BIND_PER_VERTEX);
    _geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(_corners->size())));
    _node = new osg::MatrixTransform(osg::Matrixd::translate(_origin.x, _origin.y, _origin.z));
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(_geometry);
    _node->addChild(geode);
    _node->getOrCreateStateSet()->setAttributeAndModes(makeRoadLampProgram());
    for (auto light = _lights.begin(); light != _lights.end(); light = _lights.upper_bound(light->first))
        setState(light->first, LightState::stop);
}

/// Adds a fan around the first corner. Positions are floats from the first lamp.
void RoadLamps::addFan(const std::vector<glm::dvec3>& corners, const glm::dvec3& towards)
{
    if (_corners->empty()) _origin = corners.front();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        for (const std::size_t k : {std::size_t(0), i, i + 1})
        {
            const glm::dvec3 from = corners[k] - _origin;
            _corners->push_back(osg::Vec3f(osg::Vec3d(from.x, from.y, from.z)));
            _normals->push_back(osg::Vec3f(osg::Vec3d(towards.x, towards.y, towards.z)));
        }
}

void RoadLamps::addSignal(const roads::StandingThing& thing, const std::vector<models::Lens>& lenses)
{
    Lights lights{_corners->size(), {}};
    for (const models::Lens& lens : lenses)
    {
        lights.faces.push_back(lens.face);
        std::vector<glm::dvec3> corners;
        for (int i = 0; i < kLampSides; ++i)
        {
            const double turn = -2.0 * std::numbers::pi * i / kLampSides;
            const glm::dvec3 inModel =
                lens.middle + glm::dvec3(-kLampAheadM, 0.95 * lens.radiusM * std::cos(turn),
                                         0.95 * lens.radiusM * std::sin(turn));
            corners.push_back(thing.position + thing.axes * inModel);
        }
        addFan(corners, -thing.axes[0]);
    }
    _lights.emplace(thing.signalId, lights);
}

void RoadLamps::addCeilingLamp(const roads::CeilingLamp& lamp)
{
    const glm::dvec3 along = 0.5 * lamp.lengthM * lamp.along,
                     left = 0.5 * lamp.widthM * glm::dvec3(-lamp.along.y, lamp.along.x, 0.0);
    addFan({lamp.middle - along - left, lamp.middle - along + left, lamp.middle + along + left,
            lamp.middle + along - left},
           {0.0, 0.0, -1.0});
}

/// Colours the lenses of a signal. `isLit`: of the index of a lens and all faces.
template<class IsLit>
bool RoadLamps::colour(const std::string& signalId, const IsLit& isLit)
{
    const auto [first, last] = _lights.equal_range(signalId);
    for (auto light = first; light != last; ++light)
    {
        std::size_t at = light->second.first;
        const std::vector<models::SignFace>& faces = light->second.faces;
        for (std::size_t lens = 0; lens < faces.size(); ++lens)
            for (int i = 0; i < 3 * (kLampSides - 2); ++i)
                (*_colours)[at++] =
                    isLit(lens, faces) ? lightOf(faces[lens]) : osg::Vec4f(0.0F, 0.0F, 0.0F, 0.0F);
    }
    _colours->dirty();
    return first != last;
}

bool RoadLamps::setState(const std::string& signalId, LightState state)
{
    return colour(signalId, [state](std::size_t lens, const std::vector<models::SignFace>& faces)
                  { return shines(faces[lens], faces.size() > 2, state); });
}

bool RoadLamps::setLenses(const std::string& signalId, const std::vector<bool>& lit)
{
    return colour(signalId, [&lit](std::size_t lens, const std::vector<models::SignFace>&)
                  { return lens < lit.size() && lit[lens]; });
}

} // namespace scenery
