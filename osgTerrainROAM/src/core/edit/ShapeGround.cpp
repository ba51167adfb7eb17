// SPDX-License-Identifier: Apache-2.0
#include <iterator>
#include <shared_mutex>
#include <utility>

#include <osgTerrainROAM/core/edit/HeightRule.h>
#include <osgTerrainROAM/core/edit/ShapeGround.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Distance between neighbouring grid points.
double placeM(const PlacedTile& tile)
{
    const double sampleM = std::max(tile.field().spacingEastM, tile.field().spacingNorthM);
    return std::ldexp(sampleM, -tile.grid().exponent());
}

/// Applies the works in boxes, to samples alone or to all grid points.
foundation::Result<EditReport> shape(const Earthworks& works, EditDetail detail, RoamTile& tile,
                                     TileEditor& editor)
{
    const auto boxes = works.boxes(detail == EditDetail::samples);
    auto changes = [&]
    {
        const std::shared_lock lock(tile.mutex());
        return changesBy([&](const glm::dvec2& place, double heightM)
                         { return works.heightM(place, heightM); },
                         tile.tile, boxes, detail);
    }();
    if (!changes) return changes.error();
    const bool ofSamples = detail == EditDetail::samples;
    if (ofSamples)
        std::erase_if(*changes, [&](const HeightChange& change)
                      { return !tile.tile.samples().hasSample(change.place.column, change.place.row); });
    auto report =
        editor.apply(*changes, ofSamples ? TileEditor::Between::follows : TileEditor::Between::stays);
    editor.forgetUndo();
    return report;
}

} // namespace

foundation::Result<EditReport> shapeGround(const std::vector<Earthwork>& works,
                                           const std::shared_ptr<RoamTile>& tile)
{
    const auto groundM = [&](const glm::dvec2& place) -> std::optional<double>
    {
        const auto ground = groundAt(tile->tile, place.x, place.y);
        return ground ? std::optional(tile->tile.frame().heightOf(ground->position)) : std::nullopt;
    };
    const double flatM = 1.5 * placeM(tile->tile); // then triangles across edges are level, too
    const Earthworks earthworks(works, flatM, groundM);
    if (earthworks.isEmpty()) return EditReport();
    TileEditor editor(tile);
    const bool hasFiner = tile->tile.grid().exponent() > 0;
    auto report = shape(earthworks, EditDetail::samples, *tile, editor);
    if (!report || !hasFiner) return report;
    return shape(earthworks, EditDetail::places, *tile, editor);
}

foundation::Result<EditReport> shapeGround(std::span<const std::filesystem::path> sources,
                                           const std::shared_ptr<RoamTile>& tile)
{
    std::vector<Earthwork> works;
    for (const auto& source : sources)
    {
        auto read = importEarthworks(source, tile->tile);
        if (!read) return read.error();
        std::move(read->works.begin(), read->works.end(), std::back_inserter(works));
        tile->tile.addNotes(read->notes);
    }
    return shapeGround(works, tile);
}

} // namespace osgTerrainROAM::core
