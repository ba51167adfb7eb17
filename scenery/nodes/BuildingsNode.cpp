// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/BuildingsNode.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include <osg/Geometry>
#include <osg/LOD>
#include <osg/MatrixTransform>

#include "scenery/buildings/BuildingFacets.h"
#include "scenery/nodes/ModelStates.h"
#include "scenery/nodes/ObjectShading.h"

namespace scenery
{

namespace
{

using Square = std::pair<std::int64_t, std::int64_t>;

Square squareOf(const StandingBuilding& standing, double sideM)
{
    const glm::dvec2& corner = standing.building.rings.front().front();
    return {static_cast<std::int64_t>(std::floor(corner.x / sideM)),
            static_cast<std::int64_t>(std::floor(corner.y / sideM))};
}

osg::Vec3f vectorOf(const glm::vec3& v)
{
    return {v.x, v.y, v.z};
}

osg::ref_ptr<osg::Geometry> geometryOf(const Facets& facets)
{
    const osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array, normals = new osg::Vec3Array;
    const osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
    const osg::ref_ptr<osg::Vec2Array> uvs = new osg::Vec2Array;
    for (std::size_t i = 0; i < facets.positions.size(); ++i)
    {
        positions->push_back(vectorOf(facets.positions[i]));
        normals->push_back(vectorOf(facets.normals[i]));
        colours->push_back(osg::Vec4f(vectorOf(facets.colours[i]), 1.0F));
        uvs->push_back({facets.uvs[i].x, facets.uvs[i].y});
    }
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseVertexBufferObjects(true);
    geometry->setUseDisplayList(false);
    geometry->setVertexArray(positions);
    geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, uvs, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, facets.indices.begin(), facets.indices.end()));
    return geometry;
}

/// The facets of one square, in a frame about one of its buildings.
struct SquareFacets
{
    glm::dvec3 origin{0.0};
    BuildingFacets facets;
};

/// Adds a node below `parent` that is drawn up to `farM`.
osg::Group& addRange(osg::Group& parent, const glm::dvec3& origin, double farM)
{
    const osg::ref_ptr<osg::MatrixTransform> place =
        new osg::MatrixTransform(osg::Matrixd::translate(origin.x, origin.y, origin.z));
    const osg::ref_ptr<osg::LOD> lod = new osg::LOD;
    const osg::ref_ptr<osg::Group> content = new osg::Group;
    lod->addChild(content, 0.0F, static_cast<float>(farM));
    place->addChild(lod);
    parent.addChild(place);
    return *content;
}

std::map<Square, SquareFacets> facetsBySquare(std::span<const StandingBuilding> buildings, double sideM)
{
    std::map<Square, SquareFacets> squares;
    for (const StandingBuilding& standing : buildings)
    {
        const auto [found, isNew] = squares.try_emplace(squareOf(standing, sideM));
        SquareFacets& square = found->second;
        if (isNew) square.origin = {standing.building.rings.front().front(), standing.floorM};
        addBuilding(standing, square.origin, square.facets);
    }
    return squares;
}

} // namespace

osg::ref_ptr<osg::Group> makeBuildingsNode(std::span<const StandingBuilding> buildings)
{
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    setObjectShading(*root, Finish::matt);
    ModelStates states;
    const auto add = [&](osg::Group& group, const Facets& facets, models::Painting painting)
    {
        if (facets.indices.empty()) return;
        const osg::ref_ptr<osg::Geometry> geometry = geometryOf(facets);
        geometry->setStateSet(states.stateOf({painting, models::Coat::matt}));
        group.addChild(geometry);
    };
    for (const auto& [square, made] : facetsBySquare(buildings, kShellSquareM))
    {
        osg::Group& group = addRange(*root, made.origin, kShellFarM);
        for (const auto& [painting, facets] : made.facets.shell)
            add(group, facets, painting);
    }
    for (const auto& [square, made] : facetsBySquare(buildings, kOpeningsSquareM))
        add(addRange(*root, made.origin, kOpeningsFarM), made.facets.openings,
            models::Painting::houseDetails);
    return root;
}

} // namespace scenery
