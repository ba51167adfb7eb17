// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgTerrainROAM/core/roam/RegionBounds.h>

namespace osgTerrainROAM::core
{

/// (apex, left, right) of a node, as samples.
struct RegionBounds::Corners
{
    SampleIndex apex, left, right;
};

RegionBounds::RegionBounds(const PlacedTile& tile, const ErrorTree& errors)
    : _level(std::min(kRegionLevel, tile.levels() - 1)), _spheres((4u << _level) - 2u)
{
    const auto side = static_cast<SampleIndex>(tile.side());
    const SampleIndex southEast = side - 1, northWest = side * (side - 1), northEast = side * side - 1;
    build(tile, errors, {southEast, northEast, 0}, 0, 0);
    build(tile, errors, {northWest, 0, northEast}, 0, 1);
}

void RegionBounds::build(const PlacedTile& tile, const ErrorTree& errors, const Corners& c, int level,
                         std::uint32_t path)
{
    const auto side = static_cast<SampleIndex>(tile.side());
    const auto position = [&](SampleIndex s)
    { return tile.position(static_cast<int>(s % side), static_cast<int>(s / side)); };
    const SampleIndex middle = (c.left + c.right) / 2;
    const glm::dvec3 centre = position(middle);
    double radius = errors.radiusM(middle);
    for (const SampleIndex corner : {c.apex, c.left, c.right})
        radius = std::max(radius, glm::distance(centre, position(corner)));
    sphere(level, path) = {centre, radius};
    if (level == _level) return;
    build(tile, errors, {middle, c.apex, c.left}, level + 1, 2 * path);
    build(tile, errors, {middle, c.right, c.apex}, level + 1, 2 * path + 1);
}

void RegionBounds::visible(const viewlod::Frustum& frustum, std::vector<std::uint32_t>& regions) const
{
    for (const std::uint32_t root : {0u, 1u})
        visit(frustum, 0, root, viewlod::Frustum::kAllPlanes, regions);
}

void RegionBounds::visit(const viewlod::Frustum& frustum, int level, std::uint32_t path,
                         viewlod::Frustum::Mask mask, std::vector<std::uint32_t>& regions) const
{
    const Sphere& bound = sphere(level, path);
    const auto verdict = frustum.classify(bound.centre, bound.radiusM, mask);
    if (verdict.outside) return;
    if (verdict.crossing == 0 || level == _level)
    {
        const int below = _level - level;
        for (std::uint32_t i = 0; i < 1u << below; ++i)
            regions.push_back((path << below) + i);
        return;
    }
    visit(frustum, level + 1, 2 * path, verdict.crossing, regions);
    visit(frustum, level + 1, 2 * path + 1, verdict.crossing, regions);
}

} // namespace osgTerrainROAM::core
