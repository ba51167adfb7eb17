// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/BuildingsNode.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include <osgSky/SunShadows>

#include "scenery/buildings/BuildingFacets.h"
#include "scenery/nodes/FacetNodes.h"
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

/// The facets of one square, in a frame about one of its buildings.
struct SquareFacets
{
    glm::dvec3 origin{0.0};
    BuildingFacets facets;
};

/// `add`: addShell() or addOpenings().
template<class Add>
std::map<Square, SquareFacets> facetsBySquare(std::span<const StandingBuilding> buildings, double sideM,
                                              const Add& add)
{
    std::map<Square, SquareFacets> squares;
    for (const StandingBuilding& standing : buildings)
    {
        const auto [found, isNew] = squares.try_emplace(squareOf(standing, sideM));
        SquareFacets& square = found->second;
        if (isNew) square.origin = {standing.building.rings.front().front(), standing.floorM};
        add(standing, square.origin, square.facets);
    }
    return squares;
}

} // namespace

osg::ref_ptr<osg::Group> makeBuildingsNode(std::span<const StandingBuilding> buildings,
                                           std::vector<WindowPane>* panes)
{
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    setObjectShading(*root, Finish::matt);
    ModelStates states;
    const auto add = [&](osg::Group& group, const Facets& facets, models::Painting painting)
    {
        if (facets.indices.empty()) return;
        const osg::ref_ptr<osg::Geometry> geometry = geometryOf(facets);
        geometry->setStateSet(states.stateOf({painting, models::Coat::matt}));
        geometry->setNodeMask(osgSky::SunShadows::kCastsNone);
        group.addChild(geometry);
    };
    for (const auto& [square, made] : facetsBySquare(buildings, kShellSquareM, addShell))
    {
        osg::Group& group = addOverlapping(*root, made.origin, kShellFarM);
        for (const auto& [painting, facets] : made.facets.shell)
            add(group, facets, painting);
        group.addChild(casterOf(made.facets.shell));
    }
    for (const auto& [square, made] : facetsBySquare(buildings, kOpeningsSquareM, addOpenings))
    {
        if (panes) panes->insert(panes->end(), made.facets.panes.begin(), made.facets.panes.end());
        add(addOverlapping(*root, made.origin, kOpeningsFarM), made.facets.openings,
            models::Painting::houseDetails);
    }
    return root;
}

} // namespace scenery
