// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <shared_mutex>

#include <glm/common.hpp>

#include <osgTerrainROAM/core/edit/GroundEditor.h>
#include <osgTerrainROAM/core/edit/NearestPlane.h>

namespace osgTerrainROAM::core
{

foundation::Error GroundEditor::refusal(const char* what, const char* remedy) const
{
    return {_tile->tile.field().name, what, remedy};
}

double GroundEditor::placeM() const
{
    const PlacedTile& tile = _tile->tile;
    const double step = _detail == EditDetail::places ? 1.0 : std::ldexp(1.0, tile.grid().exponent());
    const double column = 0.5 * tile.grid().dataColumns(), row = 0.5 * tile.grid().dataRows();
    const glm::dvec3 here = tile.frame().positionAt(column, row, 0.0);
    return std::max(glm::distance(here, tile.frame().positionAt(column + step, row, 0.0)),
                    glm::distance(here, tile.frame().positionAt(column, row + step, 0.0)));
}

/// Height at the grid point nearest to the vertical line through a horizontal position.
double GroundEditor::groundM(const glm::dvec2& place) const
{
    const PlacedTile& tile = _tile->tile;
    const glm::dvec2 grid = tile.frame().gridNear(place);
    const auto nearest = [](double v, int count)
    { return static_cast<int>(std::clamp(std::round(v), 0.0, count - 1.0)); };
    return tile.samples().heightM(nearest(grid.x, tile.grid().dataColumns()),
                                  nearest(grid.y, tile.grid().dataRows()));
}

foundation::Result<EditReport> GroundEditor::apply(const HeightRule& rule, std::span<const PlanBox> boxes)
{
    const EditDetail detail = _tile->tile.grid().exponent() > 0 ? _detail : EditDetail::samples;
    foundation::Result<std::vector<HeightChange>> changes = [&]
    {
        const std::shared_lock lock(_tile->mutex());
        return changesBy(rule, _tile->tile, boxes, detail);
    }();
    if (!changes) return changes.error();
    const bool ofSamples = detail == EditDetail::samples;
    // Points that only count among the samples follow the surface by themselves.
    if (ofSamples)
        std::erase_if(*changes, [&](const HeightChange& change)
                      { return !_tile->tile.samples().hasSample(change.place.column, change.place.row); });
    return _steps.apply(*changes, ofSamples ? TileEditor::Between::follows : TileEditor::Between::stays);
}

foundation::Result<EditReport> GroundEditor::applyIn(const Region& region, const HeightRule& rule)
{
    if (region.isEmpty()) return refusal("the region has no extent", "give a radius or three corners");
    const PlanBox box = region.box();
    return apply(
        [&](const glm::dvec2& place, double heightM)
        {
            const double insideM = region.insideM(place);
            if (insideM < 0.0) return heightM;
            const double share = _fadeM > 0.0 ? std::min(insideM / _fadeM, 1.0) : 1.0;
            return std::lerp(heightM, rule(place, heightM), glm::smoothstep(0.0, 1.0, share));
        },
        {&box, 1});
}

foundation::Result<EditReport> GroundEditor::setHeight(const Region& region, double heightM)
{
    return applyIn(region, [=](const glm::dvec2&, double) { return heightM; });
}

foundation::Result<EditReport> GroundEditor::raise(const Region& region, double byM)
{
    return applyIn(region, [=](const glm::dvec2&, double heightM) { return heightM + byM; });
}

foundation::Result<EditReport> GroundEditor::smooth(const Region& region, double radiusM)
{
    constexpr int kReach = 4; // nine by nine points; the middle has more weight
    return applyIn(region,
                   [&](const glm::dvec2& place, double)
                   {
                       double sum = 0.0, weights = 0.0;
                       for (int y = -kReach; y <= kReach; ++y)
                           for (int x = -kReach; x <= kReach; ++x)
                           {
                               const double weight =
                                   1.0 - (x * x + y * y) / ((kReach + 1.0) * (kReach + 1.0));
                               if (weight <= 0.0) continue;
                               sum += weight * groundM(place + glm::dvec2(x, y) * (radiusM / kReach));
                               weights += weight;
                           }
                       return sum / weights;
                   });
}

foundation::Result<EditReport> GroundEditor::flatten(const Region& region)
{
    if (region.isEmpty()) return refusal("the region has no extent", "give a radius or three corners");
    const PlanBox box = region.box();
    NearestPlane plane;
    constexpr int kPoints = 64; // along a side
    for (int y = 0; y <= kPoints; ++y)
        for (int x = 0; x <= kPoints; ++x)
        {
            const glm::dvec2 place = glm::mix(box.low, box.high, glm::dvec2(x, y) / double(kPoints));
            if (region.insideM(place) >= 0.0) plane.add(place, groundM(place));
        }
    plane.fit();
    return applyIn(region, [&](const glm::dvec2& place, double) { return plane.heightM(place); });
}

foundation::Result<EditReport> GroundEditor::stamp(const Crater& crater)
{
    if (!(crater.radiusM > 0.0)) return refusal("the crater has no extent", "give a radius");
    constexpr double kReach = 3.0; // radii: there the rim is 1/27 of its height
    const PlanBox box = PlanBox{crater.centre, crater.centre}.grownBy(kReach * crater.radiusM);
    return apply(
        [&](const glm::dvec2& place, double heightM)
        {
            const double r = glm::distance(place, crater.centre) / crater.radiusM;
            if (r >= kReach) return heightM;
            if (r < 1.0) return heightM + std::lerp(-crater.depthM, crater.rimM, r * r);
            const double last = 1.0 / (kReach * kReach * kReach);
            return heightM + crater.rimM * (1.0 / (r * r * r) - last) / (1.0 - last);
        },
        {&box, 1});
}

} // namespace osgTerrainROAM::core
