// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/RoadLamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include <osg/Geode>
#include <osgSky/Atmosphere>

#include <osgPMObjects/ObjectShader>
#include <shaders/scenery.h>

#include "scenery/models/roads/LampArrow.h"

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

const osg::Vec4f kDarkArrow(0.004F, 0.004F, 0.004F, 1.0F);

std::vector<glm::dvec2> circle()
{
    std::vector<glm::dvec2> outline;
    for (int i = 0; i < kLampSides; ++i)
    {
        const double turn = 2.0 * std::numbers::pi * i / kLampSides;
        outline.emplace_back(std::cos(turn), std::sin(turn));
    }
    return outline;
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
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, version + osgSky::Atmosphere::glslFunctions() +
                                                                  shaders::kRoadLampMain));
    osgPMObjects::bindObjectAttributes(*program);
    return program;
}

RoadLamps::RoadLamps(const roads::RoadThings& things)
{
    for (const roads::StandingThing& thing : things.standing)
        if (const models::RoadModel& model = things.models[thing.model]; !models::lensesOf(model).empty())
            addSignal(thing, model);
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

/// Lit green lamps are arrows, red and amber ones have a dark arrow on them.
/// Source: Convention on Road Signs and Signals (Vienna, 1968), article 23, 4.
void RoadLamps::addSignal(const roads::StandingThing& thing, const models::RoadModel& model)
{
    Lights lights;
    const models::Tilt tilt = models::tiltOf(model);
    const glm::dvec3 towards = thing.axes * (tilt.turn * glm::dvec3(-1.0, 0.0, 0.0));
    const auto arrow = models::arrowPieces(model.arrow);
    for (const models::Lens& lens : models::lensesOf(model))
    {
        const auto add = [&](const std::vector<glm::dvec2>& outline, double aheadM, const osg::Vec4f& light)
        {
            std::vector<glm::dvec3> corners;
            // Seen against the model's x, its y and z run clockwise.
            for (auto at = outline.rbegin(); at != outline.rend(); ++at)
                corners.push_back(thing.position +
                                  thing.axes *
                                      tilt.at(lens.middle + glm::dvec3(-aheadM, 0.95 * lens.radiusM * at->x,
                                                                       0.95 * lens.radiusM * at->y)));
            const std::size_t first = _corners->size();
            addFan(corners, towards);
            lights.pieces.push_back({lights.faces.size(), first, _corners->size() - first, light});
        };
        const bool isArrowAlone = !arrow.empty() && lens.face == models::SignFace::lampGreen;
        if (!isArrowAlone) add(circle(), kLampAheadM, lightOf(lens.face));
        for (const auto& piece : arrow)
            add(piece, isArrowAlone ? kLampAheadM : 2.0 * kLampAheadM,
                isArrowAlone ? lightOf(lens.face) : kDarkArrow);
        lights.faces.push_back(lens.face);
    }
    _lights.emplace(thing.signalId, std::move(lights));
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
        for (const Piece& piece : light->second.pieces)
            std::fill_n(_colours->begin() + static_cast<std::ptrdiff_t>(piece.first), piece.count,
                        isLit(piece.lens, light->second.faces) ? piece.light
                                                               : osg::Vec4f(0.0F, 0.0F, 0.0F, 0.0F));
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
