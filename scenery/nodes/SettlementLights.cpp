// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/SettlementLights.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geometry>
#include <osgSky/Atmosphere>
#include <osgSky/SunShadows>

#include <osgTraversal/DrawOrder>
#include <shaders/scenery.h>

#include "scenery/lights/LitTimes.h"
#include "scenery/nodes/FacetNodes.h"
#include "scenery/nodes/ModelMesh.h"
#include "scenery/nodes/ObjectShading.h"

namespace scenery
{

namespace
{

constexpr double kSettlementSquareM = 500.0, kPostsFarM = 500.0, kWindowsFarM = 900.0, kPoolsFarM = 1800.0;
constexpr double kPoolHalfM = 16.0, kPoolAboveM = 0.12;
constexpr double kWindowCd = 90.0; ///< 1.5 m² of 60 cd/m²
/// linear, beside a white wall in the sun of 1.95: what an eye that is used to the dark sees
constexpr double kWindowLight = 0.42;

using PlanSquare = std::pair<std::int64_t, std::int64_t>;

PlanSquare squareAt(const glm::dvec3& place)
{
    return {static_cast<std::int64_t>(std::floor(place.x / kSettlementSquareM)),
            static_cast<std::int64_t>(std::floor(place.y / kSettlementSquareM))};
}

osg::Vec3f osgVector(const glm::dvec3& v)
{
    return osg::Vec3f(osg::Vec3d(v.x, v.y, v.z));
}

osg::ref_ptr<osg::Program> lampProgramOf(const char* name, const std::string& vertex,
                                         const std::string& fragment)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName(name);
    const std::string version = "#version 130\n";
    program->addShader(new osg::Shader(osg::Shader::VERTEX, version + vertex));
    program->addShader(
        new osg::Shader(osg::Shader::FRAGMENT, version + osgSky::Atmosphere::glslFunctions() + fragment));
    return program;
}

/// Squares with one coloured, textured corner for each vertex.
struct LitSquares
{
    osg::ref_ptr<osg::Vec3Array> places = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> colours = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> uvs = new osg::Vec4Array;
    osg::ref_ptr<osg::DrawElementsUInt> faces = new osg::DrawElementsUInt(GL_TRIANGLES);

    void corner(const glm::dvec3& place, const glm::vec3& colour, const osg::Vec4f& uv)
    {
        places->push_back(osgVector(place));
        colours->push_back({colour.x, colour.y, colour.z});
        uvs->push_back(uv);
    }

    /// Two triangles of the corners at numbers.
    void face(unsigned a, unsigned b, unsigned c, unsigned d)
    {
        for (const unsigned corner : {a, b, c, a, c, d})
            faces->push_back(corner);
    }

    osg::ref_ptr<osg::Geometry> geometry() const
    {
        const osg::ref_ptr<osg::Geometry> made = new osg::Geometry;
        made->setUseDisplayList(false);
        made->setUseVertexBufferObjects(true);
        made->setVertexArray(places);
        made->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
        made->setTexCoordArray(0, uvs, osg::Array::BIND_PER_VERTEX);
        made->addPrimitiveSet(faces);
        return made;
    }
};

/// What lies in the squares of the plan, each about an origin of its own.
struct LitContent
{
    glm::dvec3 origin{0.0};
    LitSquares squares;
};
using LitContents = std::map<PlanSquare, LitContent>;

LitContent& contentAt(LitContents& contents, const glm::dvec3& place)
{
    const auto [found, isNew] = contents.try_emplace(squareAt(place));
    if (isNew) found->second.origin = place;
    return found->second;
}

osg::ref_ptr<osg::Group> groupOf(const LitContents& contents, double farM,
                                 const osg::ref_ptr<osg::StateSet>& state)
{
    if (contents.empty()) return nullptr;
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    for (const auto& [square, content] : contents)
        addOverlapping(*group, content.origin, farM).addChild(content.squares.geometry());
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    group->setStateSet(state);
    return group;
}

/// The colour of a room's light: warm, neutral, or that of a screen.
glm::vec3 roomColour(std::uint64_t room)
{
    constexpr int kKinds = 8;
    const auto kind = static_cast<int>((room >> 20U) % kKinds);
    const float strength = 0.55F + 0.45F * static_cast<float>((room >> 32U) % 256U) / 255.0F;
    const glm::vec3 colour = kind < 5   ? glm::vec3(1.0F, 0.66F, 0.32F)
                             : kind < 7 ? glm::vec3(1.0F, 0.84F, 0.60F)
                                        : glm::vec3(0.55F, 0.72F, 1.0F);
    return strength * colour;
}

void addPane(const WindowPane& pane, const Flash& lit, LitContents& contents)
{
    LitContent& content = contentAt(contents, pane.left);
    LitSquares& squares = content.squares;
    const auto first = static_cast<unsigned>(squares.places->size());
    const glm::vec3 colour = static_cast<float>(kWindowLight) * roomColour(pane.room);
    const glm::dvec3 up(0.0, 0.0, pane.heightM);
    const auto start = static_cast<float>(lit.startS), length = static_cast<float>(lit.litS);
    squares.corner(pane.left - content.origin, colour, {0.0F, 0.0F, start, length});
    squares.corner(pane.right - content.origin, colour, {1.0F, 0.0F, start, length});
    squares.corner(pane.right + up - content.origin, colour, {1.0F, 1.0F, start, length});
    squares.corner(pane.left + up - content.origin, colour, {0.0F, 1.0F, start, length});
    squares.face(first, first + 1, first + 2, first + 3);
}

LightPoint pointOf(const WindowPane& pane, const Flash& lit)
{
    const glm::dvec3 along = pane.right - pane.left;
    LightPoint point;
    point.place = 0.5 * (pane.left + pane.right) + glm::dvec3(0.0, 0.0, 0.5 * pane.heightM);
    const glm::vec3 colour = roomColour(pane.room);
    point.colour = colour / std::max({colour.r, colour.g, colour.b});
    point.candela = kWindowCd * glm::length(along) * pane.heightM / 1.5;
    point.headingDeg = glm::degrees(std::atan2(-along.x, along.y)); // out of the wall: to the right of it
    point.beam = BeamKind::window;
    point.group = LightGroup::window;
    point.flash = lit;
    return point;
}

/// Nine corners on the ground about a lamp; nothing where it has no height.
void addPool(const LightPoint& light, double groundM, const foundation::HeightInPlan& ground,
             LitContents& contents)
{
    LitContent& content = contentAt(contents, light.place);
    LitSquares& squares = content.squares;
    const auto first = static_cast<unsigned>(squares.places->size());
    const double highM = light.place.z - groundM;
    for (const double y : {-1.0, 0.0, 1.0})
        for (const double x : {-1.0, 0.0, 1.0})
        {
            const glm::dvec2 from = kPoolHalfM * glm::dvec2(x, y), place = glm::dvec2(light.place) + from;
            const glm::dvec3 corner(place, ground(place).value_or(groundM) + kPoolAboveM);
            squares.corner(corner - content.origin, light.colour,
                           osg::Vec4f(osg::Vec4d(from.x, from.y, highM, 0.0)));
        }
    for (const unsigned row : {0U, 3U})
        for (const unsigned column : {0U, 1U})
        {
            const unsigned corner = first + row + column;
            squares.face(corner, corner + 1, corner + 4, corner + 3);
        }
}

void addPost(const StreetLamp& lamp, double groundM, ModelMesh& mesh, const glm::dvec3& origin)
{
    const osg::Vec4f zinc(0.55F, 0.56F, 0.57F, 1.0F), dark(0.25F, 0.26F, 0.27F, 1.0F);
    const glm::dvec3 foot = glm::dvec3(lamp.place, groundM) - origin, along(lamp.towards, 0.0),
                     top = foot + glm::dvec3(0.0, 0.0, lamp.heightM);
    mesh.addBar(osgVector(foot - glm::dvec3(0.0, 0.0, 0.4)), osgVector(top), 0.055F, zinc);
    mesh.addBar(osgVector(top), osgVector(top + 1.0 * along), 0.035F, zinc);
    mesh.addBar(osgVector(top + 0.8 * along - glm::dvec3(0.0, 0.0, 0.03)),
                osgVector(top + 1.5 * along - glm::dvec3(0.0, 0.0, 0.03)), 0.09F, dark);
}

/// The posts of lamps, by squares.
osg::ref_ptr<osg::Group> postsOf(const std::vector<std::pair<StreetLamp, double>>& lamps)
{
    struct Posts
    {
        glm::dvec3 origin{0.0};
        ModelMesh mesh;
    };
    std::map<PlanSquare, Posts> squares;
    for (const auto& [lamp, groundM] : lamps)
    {
        const glm::dvec3 foot(lamp.place, groundM);
        const auto [found, isNew] = squares.try_emplace(squareAt(foot));
        if (isNew) found->second.origin = foot;
        addPost(lamp, groundM, found->second.mesh, found->second.origin);
    }
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    setObjectShading(*group, Finish::matt);
    for (const auto& [square, posts] : squares)
        addOverlapping(*group, posts.origin, kPostsFarM).addChild(posts.mesh.geometry());
    group->setNodeMask(osgSky::SunShadows::kCastsNone);
    return group;
}

} // namespace

osg::ref_ptr<osg::Program> makeWindowProgram()
{
    return lampProgramOf("lit window", shaders::kWindowVertexMain, shaders::kWindowMain);
}

osg::ref_ptr<osg::Program> makeLampPoolProgram()
{
    return lampProgramOf("ground below a lamp", shaders::kLampPoolVertexMain, shaders::kLampPoolMain);
}

SettlementLights::SettlementLights(const std::vector<StreetLamp>& lamps, std::vector<WindowPane> panes,
                                   std::vector<LightPoint> others, foundation::HeightInPlan ground)
    : _unlit(Unlit{{}, std::move(panes), std::move(others), std::move(ground)}),
      _poolLevel(new osg::Uniform("lightPools", 1.0F))
{
    for (const StreetLamp& lamp : lamps)
        if (const auto groundM = _unlit->ground(lamp.place)) _unlit->lamps.emplace_back(lamp, *groundM);
    std::erase_if(_unlit->panes,
                  [](const WindowPane& pane) { return !(litTimes(pane.use, pane.room).litS > 0.0); });
    _count = _unlit->others.size() + _unlit->lamps.size() + _unlit->panes.size();
    if (!_unlit->lamps.empty()) _root->addChild(postsOf(_unlit->lamps));
    showPoints(_unlit->others);
    light({});
}

/// Shows these light points alone.
void SettlementLights::showPoints(std::span<const LightPoint> points)
{
    if (_points && _points->node()) _root->removeChild(_points->node());
    _points.emplace(points);
    if (_points->node()) _root->addChild(_points->node());
}

void SettlementLights::makeLights(const Unlit& from)
{
    LitContents windows, pools;
    std::vector<LightPoint> points = from.others;
    for (const auto& [lamp, groundM] : from.lamps)
    {
        points.push_back(lightOf(lamp, groundM));
        addPool(points.back(), groundM, from.ground, pools);
    }
    for (const WindowPane& pane : from.panes)
    {
        const Flash lit = litTimes(pane.use, pane.room);
        addPane(pane, lit, windows);
        points.push_back(pointOf(pane, lit));
    }
    const osg::ref_ptr<osg::StateSet> ofWindows = new osg::StateSet, ofPools = new osg::StateSet;
    ofWindows->setAttributeAndModes(makeWindowProgram());
    ofPools->setAttributeAndModes(makeLampPoolProgram());
    ofPools->addUniform(_poolLevel);
    ofPools->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE));
    ofPools->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    ofPools->setRenderBinDetails(osgTraversal::DrawOrder::kSky + 1, "RenderBin"); // on all that is opaque
    _windows = groupOf(windows, kWindowsFarM, ofWindows);
    _pools = groupOf(pools, kPoolsFarM, ofPools);
    for (const auto& node : {_windows, _pools})
        if (node) _root->addChild(node);
    showPoints(points);
}

void SettlementLights::light(const LightLevels& levels)
{
    const float street = levels[static_cast<std::size_t>(LightGroup::street)];
    const bool areWindowsLit = levels[static_cast<std::size_t>(LightGroup::window)] > 0.0F;
    constexpr unsigned kShown = osgSky::SunShadows::kCastsNone;
    if (_unlit && (street > 0.0F || areWindowsLit))
    {
        makeLights(*_unlit);
        _unlit.reset();
    }
    _points->light(levels);
    _poolLevel->set(street);
    if (_windows) _windows->setNodeMask(areWindowsLit ? kShown : 0U);
    if (_pools) _pools->setNodeMask(street > 0.0F ? kShown : 0U);
}

} // namespace scenery
