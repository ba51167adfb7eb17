// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include <osgTerrainROAM/core/heightfield/SampleRaster.h>
#include <osgTerrainROAM/core/roam/RegionBounds.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Computes the smallest sphere about the centre of the samples' box.
template<class Sphere>
Sphere fitted(const SampleRaster& tile, const GridTriangle& triangle)
{
    glm::dvec3 lowest(std::numeric_limits<double>::max()), highest(std::numeric_limits<double>::lowest());
    Sphere sphere{glm::dvec3(0.0), 0.0, std::numeric_limits<double>::lowest()};
    static thread_local std::vector<glm::dvec3> positions; // its memory is kept
    positions.clear();
    triangle.forEachRow(tile.side(), tile.side(),
                        [&](int row, int west, int east)
                        {
                            for (int column = west; column <= east; ++column)
                            {
                                const glm::dvec3& position =
                                    positions.emplace_back(tile.position(column, row));
                                lowest = glm::min(lowest, position);
                                highest = glm::max(highest, position);
                                sphere.highestM =
                                    std::max<double>(sphere.highestM, tile.heightM(column, row));
                            }
                        });
    sphere.centre = (lowest + highest) * 0.5;
    double farthest = 0.0; // squared
    for (const glm::dvec3& position : positions)
    {
        const glm::dvec3 way = position - sphere.centre;
        farthest = std::max(farthest, glm::dot(way, way));
    }
    sphere.radiusM = std::sqrt(farthest);
    return sphere;
}

/// Computes a sphere around two others, about the middle of their centres.
template<class Sphere>
Sphere joined(const Sphere& a, const Sphere& b)
{
    const glm::dvec3 centre = (a.centre + b.centre) * 0.5;
    return {centre, 0.5 * glm::distance(a.centre, b.centre) + std::max(a.radiusM, b.radiusM),
            std::max(a.highestM, b.highestM)};
}

} // namespace

RegionBounds::RegionBounds(const PlacedTile& tile)
    : _level(std::min(kRegionLevel, SampleRaster(tile).levels() - 1)),
      _geoidM(highestGeoidM(tile.field())),
      _cellShift(std::bit_width(4u * static_cast<unsigned>(tile.grid().side() - 1)) - 1 - (_level - 1) / 2),
      _paths(regionCount()),
      _spheres((4u << _level) - 2u)
{
    assert(_level % 2 == 1);
    const auto roots = rootTriangles(tile.grid().side());
    number(roots[0], 0, 0);
    number(roots[1], 0, 1);
}

void RegionBounds::number(const GridTriangle& t, int level, std::uint32_t path)
{
    if (level == _level)
    {
        const GridPoint inside{2 * t.apex.column + t.left.column + t.right.column,
                               2 * t.apex.row + t.left.row + t.right.row};
        _paths[cellQuarter(inside)] = static_cast<std::uint16_t>(path);
        return;
    }
    const auto children = t.children();
    number(children[0], level + 1, 2 * path);
    number(children[1], level + 1, 2 * path + 1);
}

void RegionBounds::fit(const PlacedTile& tile)
{
    const auto roots = rootTriangles(tile.grid().side());
    fit(tile, roots[0], 0, 0);
    fit(tile, roots[1], 0, 1);
    for (Sphere& sphere : _spheres)
        sphere.highestM += _geoidM;
}

void RegionBounds::fit(const PlacedTile& tile, const GridTriangle& t, int level, std::uint32_t path)
{
    if (level == _level)
    {
        const int shift = tile.grid().exponent();
        const auto sample = [shift](GridPoint p) { return GridPoint{p.column >> shift, p.row >> shift}; };
        sphere(level, path) =
            fitted<Sphere>(SampleRaster(tile), {sample(t.apex), sample(t.left), sample(t.right)});
        return;
    }
    const auto children = t.children();
    fit(tile, children[0], level + 1, 2 * path);
    fit(tile, children[1], level + 1, 2 * path + 1);
    sphere(level, path) = joined(sphere(level + 1, 2 * path), sphere(level + 1, 2 * path + 1));
}

void RegionBounds::include(const PlacedTile& tile, GridPoint place)
{
    const double heightM = tile.samples().heightM(place.column, place.row) + _geoidM;
    const auto roots = rootTriangles(tile.grid().side());
    for (const std::uint32_t root : {0u, 1u})
        include(roots[root], 0, root, place, tile.position(place.column, place.row), heightM);
}

void RegionBounds::include(const GridTriangle& t, int level, std::uint32_t path, GridPoint place,
                           const glm::dvec3& position, double heightM)
{
    if (!t.holds(place)) return;
    Sphere& bound = sphere(level, path);
    bound.radiusM = std::max(bound.radiusM, glm::distance(bound.centre, position));
    bound.highestM = std::max(bound.highestM, heightM);
    if (level == _level) return;
    const auto children = t.children();
    include(children[0], level + 1, 2 * path, place, position, heightM);
    include(children[1], level + 1, 2 * path + 1, place, position, heightM);
}

void RegionBounds::visible(const viewlod::Frustum& frustum, const Horizon* horizon,
                           std::vector<std::uint32_t>& regions) const
{
    Search search{frustum, regions};
    for (const std::uint32_t root : {0u, 1u})
        visit(search, 0, root, viewlod::Frustum::kAllPlanes, horizon);
}

void RegionBounds::visit(Search& search, int level, std::uint32_t path, viewlod::Frustum::Mask mask,
                         const Horizon* horizon) const
{
    const Sphere& bound = sphere(level, path);
    const auto verdict = search.frustum.classify(bound.centre, bound.radiusM, mask);
    if (verdict.outside) return;
    if (horizon && horizon->isNearer(bound.centre, bound.radiusM)) horizon = nullptr; // for all below, too
    if (horizon && horizon->hides(bound.centre, bound.radiusM, bound.highestM)) return;
    if ((verdict.crossing == 0 && !horizon) || level == _level)
    {
        const int below = _level - level;
        for (std::uint32_t i = 0; i < 1u << below; ++i)
            search.regions.push_back((path << below) + i);
        return;
    }
    visit(search, level + 1, 2 * path, verdict.crossing, horizon);
    visit(search, level + 1, 2 * path + 1, verdict.crossing, horizon);
}

} // namespace osgTerrainROAM::core
