// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/SkyShadeNode.h"

#include <cmath>

#include <glm/glm.hpp>

#include <osg/Geode>
#include <osg/Program>
#include <osgSky/SunShadows>

#include <shaders/scenery.h>

#include "scenery/nodes/OcclusionProgram.h"

namespace scenery
{

namespace
{

constexpr double kCellM = 16.0;

std::pair<int, int> cellOf(const glm::dvec2& place)
{
    const glm::ivec2 cell(glm::floor(place / kCellM));
    return {cell.x, cell.y};
}

osg::ref_ptr<osg::StateSet> patchState()
{
    constexpr int kBin = 8; // after the ground, before shadows of what moves
    osg::ref_ptr<osg::StateSet> state = makeOcclusionState(makeSkyShadeProgram(), kBin);
    state->addUniform(new osg::Uniform("skyShadeReachM", static_cast<float>(SkyShadeNode::kReachM)));
    return state;
}

/// What lies so near to a place, along each axis, is sorted at once.
constexpr double kSortedM = 1024.0;

bool isNear(const glm::dvec2& place, const glm::dvec2& middle, double withinM)
{
    return glm::all(glm::lessThanEqual(glm::abs(place - middle), glm::dvec2(withinM)));
}

/// The numbers of bodies, then of walls by their middle, near a place, by cells.
std::map<std::pair<int, int>, std::vector<std::size_t>> cellsOf(const SkyOccluders& occluders,
                                                                const glm::dvec2& middle)
{
    std::map<std::pair<int, int>, std::vector<std::size_t>> cells;
    std::size_t number = 0;
    const auto add = [&](const glm::dvec2& place)
    {
        if (isNear(place, middle, kSortedM)) cells[cellOf(place)].push_back(number);
        ++number;
    };
    for (const SkyOccluder& body : occluders.bodies)
        add(body.place);
    for (const SkyWall& wall : occluders.walls)
        add(0.5 * (wall.from + wall.to));
    return cells;
}

} // namespace

osg::ref_ptr<osg::Program> makeSkyShadeProgram()
{
    return makeOcclusionProgram("sky shade", shaders::kSkyShadeMain);
}

SkyShadeNode::SkyShadeNode(SkyOccluders occluders, foundation::HeightInPlan ground)
    : _occluders(std::move(occluders)),
      _ground(std::move(ground)),
      _geometry(new osg::Geometry),
      _placed(new osg::MatrixTransform)
{
    _geometry->setDataVariance(osg::Object::DYNAMIC);
    _geometry->setUseDisplayList(false);
    _geometry->setUseVertexBufferObjects(true);
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(_geometry);
    geode->setStateSet(patchState());
    _placed->setName("sky shade");
    _placed->setDataVariance(osg::Object::DYNAMIC);
    _placed->addChild(geode);
    _placed->setNodeMask(0);
}

void SkyShadeNode::setShown(bool isShown)
{
    if (isShown == _isShown) return;
    _isShown = isShown;
    _eye.reset();
}

const SkyShadePatch& SkyShadeNode::patchOf(std::size_t occluder)
{
    const auto [found, isNew] = _patches.try_emplace(occluder);
    const std::size_t bodies = _occluders.bodies.size();
    if (isNew)
        found->second = occluder < bodies ? patchBelow(_occluders.bodies[occluder], _ground)
                                          : patchBefore(_occluders.walls[occluder - bodies], _ground);
    return found->second;
}

void SkyShadeNode::follow(const glm::dvec3& eye)
{
    const Cell cell = cellOf(glm::dvec2(eye));
    if (_eye == cell) return;
    _eye = cell;
    gather(eye);
}

void SkyShadeNode::gather(const glm::dvec3& eye)
{
    constexpr int kAround = static_cast<int>(kReachM / kCellM) + 2; // a long wall has its middle farther off
    const osg::ref_ptr<osg::Vec3Array> places = new osg::Vec3Array;
    const osg::ref_ptr<osg::Vec2Array> hidden = new osg::Vec2Array;
    const osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    std::map<std::size_t, SkyShadePatch> near;
    constexpr double kLeftM = kCellM * (kAround + 1);
    if (const glm::dvec2 place(eye); _isShown && !(_sortedAt && isNear(place, *_sortedAt, kSortedM - kLeftM)))
    {
        _inCell = cellsOf(_occluders, place);
        _sortedAt = place;
    }
    for (int y = -kAround; _isShown && y <= kAround; ++y)
        for (int x = -kAround; x <= kAround; ++x)
        {
            const auto found = _inCell.find({_eye->first + x, _eye->second + y});
            if (found == _inCell.end()) continue;
            for (const std::size_t occluder : found->second)
            {
                const SkyShadePatch& patch = patchOf(occluder);
                const auto first = static_cast<std::uint32_t>(places->size());
                for (const SkyShadePatch::Corner& corner : patch.corners)
                {
                    const glm::vec3 at(corner.place - eye);
                    places->push_back({at.x, at.y, at.z});
                    hidden->push_back({corner.hidden, 0.0F});
                }
                for (const std::uint32_t corner : patch.triangles)
                    triangles->push_back(first + corner);
                near[occluder] = patch;
            }
        }
    _patches = std::move(near);
    _placed->setNodeMask(triangles->empty() ? 0U : osgSky::SunShadows::kCastsNone);
    _placed->setMatrix(osg::Matrixd::translate(eye.x, eye.y, eye.z));
    _geometry->setVertexArray(places);
    _geometry->setTexCoordArray(0, hidden, osg::Array::BIND_PER_VERTEX);
    _geometry->removePrimitiveSet(0, _geometry->getNumPrimitiveSets());
    _geometry->addPrimitiveSet(triangles);
    _geometry->dirtyBound();
}

} // namespace scenery
