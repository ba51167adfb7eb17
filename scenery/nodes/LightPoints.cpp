// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/LightPoints.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/PointSprite>
#include <osg/Texture2D>
#include <osgSky/Atmosphere>
#include <osgSky/SunShadows>

#include <shaders/scenery.h>

namespace scenery
{

namespace
{

constexpr int kBeamColumns = 1441; ///< a quarter of a degree aside, an eighth up
constexpr int kBeamUnit = 15;      ///< of textures: no surface has so many
constexpr BeamPoint kLevel{0.0, 1.0};

osg::ref_ptr<osg::Texture2D> beamTexture()
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kBeamColumns, 2 * kBeamKinds, 1, GL_RED, GL_FLOAT);
    image->setInternalTextureFormat(GL_R32F);
    for (int kind = 0; kind < kBeamKinds; ++kind)
        for (int column = 0; column < kBeamColumns; ++column)
        {
            const double at = static_cast<double>(column) / (kBeamColumns - 1);
            const Beam& beam = beamOf(static_cast<BeamKind>(kind));
            const double ahead = shareOf(Beam{beam.aside, {&kLevel, 1}}, 360.0 * at - 180.0, 0.0);
            const double up = shareOf(Beam{{&kLevel, 1}, beam.up}, 0.0, 180.0 * at - 90.0);
            *reinterpret_cast<float*>(image->data(
                static_cast<unsigned>(column), 2U * static_cast<unsigned>(kind))) = static_cast<float>(ahead);
            *reinterpret_cast<float*>(
                image->data(static_cast<unsigned>(column), 2U * static_cast<unsigned>(kind) + 1U)) =
                static_cast<float>(up);
        }
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

osg::ref_ptr<osg::StateSet> lightState()
{
    const osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(makeLightPointProgram());
    state->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    state->setMode(GL_VERTEX_PROGRAM_POINT_SIZE, osg::StateAttribute::ON);
    state->addUniform(new osg::Uniform("drawnPixels", 1.0F));    // cameras tell other sides
    state->setTextureAttributeAndModes(0, new osg::PointSprite); // squares, with four samples, too
    state->setRenderBinDetails(11, "DepthSortedBin");            // after what is blended
    return state;
}

/// The bound of lamps reaches so far that they are no small feature, which cull leaves out, from where they
/// are seen.
struct FarSeen : osg::Drawable::ComputeBoundingBoxCallback
{
    osg::BoundingBox computeBound(const osg::Drawable& drawable) const override
    {
        constexpr float kReachM = 60.0F;
        osg::BoundingBox box = drawable.computeBoundingBox();
        box._min -= osg::Vec3f(kReachM, kReachM, kReachM);
        box._max += osg::Vec3f(kReachM, kReachM, kReachM);
        return box;
    }
};

osg::ref_ptr<osg::Geometry> pointsOf(std::span<const LightPoint* const> lights, const glm::dvec3& origin)
{
    const osg::ref_ptr<osg::Vec3Array> places = new osg::Vec3Array, beams = new osg::Vec3Array;
    const osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array, flashes = new osg::Vec4Array,
                                       below = new osg::Vec4Array;
    const osg::ref_ptr<osg::FloatArray> rows = new osg::FloatArray;
    for (const LightPoint* const light : lights)
    {
        const glm::vec3 from(light->place - origin), colour(light->colour);
        const double heading = glm::radians(light->headingDeg);
        places->push_back({from.x, from.y, from.z});
        beams->push_back(osg::Vec3f(osg::Vec3d(std::cos(heading), std::sin(heading), light->tiltDeg)));
        colours->push_back({colour.x, colour.y, colour.z, static_cast<float>(light->candela)});
        flashes->push_back(osg::Vec4f(osg::Vec4d(light->flash.periodS, light->flash.startS, light->flash.litS,
                                                 static_cast<double>(light->group))));
        const ColourBelow other = light->below.value_or(ColourBelow{colour, -1000.0});
        below->push_back(
            {other.colour.x, other.colour.y, other.colour.z, static_cast<float>(other.angleDeg)});
        rows->push_back(2.0F * static_cast<float>(light->beam));
    }
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setDataVariance(osg::Object::DYNAMIC);
    geometry->setComputeBoundingBoxCallback(new FarSeen);
    geometry->setVertexArray(places);
    geometry->setNormalArray(beams, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, flashes, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(1, below, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(2, rows, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(places->size())));
    return geometry;
}

} // namespace

osg::ref_ptr<osg::Program> makeLightPointProgram()
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("light point");
    const std::string before = std::string("#version 130\n") + osgSky::Atmosphere::glslFunctions();
    program->addShader(new osg::Shader(osg::Shader::VERTEX, before + shaders::kLightPointVertexMain));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, before + shaders::kLightPointMain));
    return program;
}

LightPoints::LightPoints(std::span<const LightPoint> lights, double tileM)
{
    if (lights.empty()) return;
    using Square = std::pair<std::int64_t, std::int64_t>;
    std::map<Square, std::vector<const LightPoint*>> squares;
    for (const LightPoint& light : lights)
    {
        const glm::dvec2 at = tileM > 0.0 ? glm::floor(glm::dvec2(light.place) / tileM) : glm::dvec2(0.0);
        squares[{static_cast<std::int64_t>(at.x), static_cast<std::int64_t>(at.y)}].push_back(&light);
    }
    _node = new osg::Group;
    _node->setStateSet(lightState());
    _node->setNodeMask(osgSky::SunShadows::kCastsNone);
    for (const LightPoint& light : lights)
        if (tileM <= 0.0) _candela.push_back(static_cast<float>(light.candela));
    for (const auto& [square, its] : squares)
    {
        const glm::dvec3 origin = its.front()->place;
        const osg::ref_ptr<osg::MatrixTransform> place =
            new osg::MatrixTransform(osg::Matrixd::translate(origin.x, origin.y, origin.z));
        const osg::ref_ptr<osg::Geometry> points = pointsOf(its, origin);
        place->addChild(points);
        if (tileM <= 0.0) _colours = static_cast<osg::Vec4Array*>(points->getColorArray());
        _node->addChild(place);
        Tile tile;
        tile.node = place;
        for (const LightPoint* const light : its)
            tile.groups |= 1U << static_cast<unsigned>(light->group);
        _tiles.push_back(tile);
    }
}

void LightPoints::light(const LightLevels& levels)
{
    unsigned lit = 0;
    for (std::size_t i = 0; i < levels.size(); ++i)
        if (levels[i] > 0.0F) lit |= 1U << static_cast<unsigned>(i);
    for (const Tile& tile : _tiles)
        tile.node->setNodeMask((tile.groups & lit) != 0 ? ~0U : 0U);
}

void LightPoints::dim(std::span<const float> shares)
{
    if (!_colours) return;
    for (std::size_t i = 0; i < shares.size(); ++i)
        (*_colours)[i].a() = shares[i] * _candela[i];
    _colours->dirty();
}

LightUniforms::LightUniforms(osg::StateSet& scene)
    : _leastLx(new osg::Uniform("lightLeastLx", 1e-3F)),
      _timeS(new osg::Uniform("lightTimeS", 0.0F)),
      _dayS(new osg::Uniform("lightDayS", 0.0F)),
      _levels(new osg::Uniform(osg::Uniform::FLOAT, "lightLevels", kLightGroups))
{
    scene.setTextureAttribute(kBeamUnit, beamTexture());
    scene.addUniform(new osg::Uniform("lightBeams", kBeamUnit));
    for (const auto& uniform : {_leastLx, _timeS, _dayS, _levels})
        scene.addUniform(uniform);
    show(1e-3, 0.0, 0.0, {});
}

void LightUniforms::show(double leastLx, double timeS, double dayS, const LightLevels& levels)
{
    _leastLx->set(static_cast<float>(leastLx));
    _timeS->set(static_cast<float>(timeS));
    _dayS->set(static_cast<float>(dayS));
    for (std::size_t i = 0; i < levels.size(); ++i)
        _levels->setElement(static_cast<unsigned>(i), levels[i]);
}

} // namespace scenery
