// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/MeasureChanges.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <osgTerrainROAM/core/edit/TileEditor.h>

#include "compare/terrain/drivers/Measured.h"
#include "measurement/Percentile.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

/// Flies the first frames, and returns the median of the time and the mean of the vertices written.
std::pair<double, double> firstFrames(RivalMesh& mesh, const ComparedFlight& flight, double tolerancePx)
{
    constexpr std::size_t kMostFrames = 12;
    const std::size_t frames = std::min(flight.views.size(), kMostFrames);
    std::vector<double> us;
    double vertices = 0.0;
    for (std::size_t frame = 0; frame < frames; ++frame)
    {
        const double frameUs =
            microsecondsOf([&] { mesh.refine(flight.views[frame], {.errorTolerancePx = tolerancePx}); });
        if (frame == 0) continue;
        us.push_back(frameUs);
        vertices += static_cast<double>(mesh.written().vertices);
    }
    return {measurement::percentile(us, 0.5), vertices / static_cast<double>(us.size())};
}

} // namespace

std::optional<GridPoint> sampleInSight(const PlacedTile& tile, const viewlod::ViewState& view)
{
    constexpr double kMiddle = 0.85, kFarM = 1e30;
    std::optional<GridPoint> found;
    double nearestM = kFarM;
    const int step = 1 << tile.grid().exponent();
    for (int row = step; row < tile.grid().dataRows() - step; row += step)
        for (int column = step; column < tile.grid().dataColumns() - step; column += step)
        {
            const glm::dvec3 place = tile.position(column, row);
            const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(place, 1.0);
            if (clip.w <= 0.0 || std::max(std::abs(clip.x), std::abs(clip.y)) > kMiddle * clip.w) continue;
            const double distanceM = glm::distance(place, view.eyeWorld);
            if (distanceM >= nearestM) continue;
            nearestM = distanceM;
            found = GridPoint{column, row};
        }
    return found;
}

std::optional<MorphFigures> measureMorph(const Rival& rival, const ComparedFlight& flight, double tolerancePx)
{
    const auto morphing = rival.newMesh(), plain = rival.newMesh();
    if (!morphing->setMorphing(true)) return std::nullopt;
    const auto [us, vertices] = firstFrames(*morphing, flight, tolerancePx);
    const auto [plainUs, plainVertices] = firstFrames(*plain, flight, tolerancePx);
    return MorphFigures{us, plainUs, vertices, plainVertices};
}

void measureEdits(const Rivals& rivals, const ComparedFlight& flight, std::vector<MethodFigures>& methods)
{
    constexpr int kEdits = 8;
    constexpr double kDepth =
        0.005; // of each edit, as a share of the distance: some 5 pixels, so that it stays in sight
    const viewlod::ViewState& view = flight.views.front();
    const PlacedTile& tile = rivals.tile->tile;
    const auto place = sampleInSight(tile, view);
    if (!place) return;
    const double depthM = kDepth * glm::distance(tile.position(place->column, place->row), view.eyeWorld);
    std::vector<std::unique_ptr<RivalMesh>> meshes;
    for (std::size_t i = 0; i < rivals.all.size(); ++i)
    {
        meshes.push_back(rivals.all[i].newMesh());
        meshes.back()->refine(view, {.errorTolerancePx = methods[i].tolerancePx});
    }
    TileEditor editor(rivals.tile);
    std::vector<std::vector<double>> us(meshes.size());
    for (int edit = 0; edit < kEdits; ++edit)
    {
        const HeightChange change{
            *place, static_cast<float>(tile.samples().heightM(place->column, place->row) - depthM)};
        if (!editor.apply(std::span(&change, 1), TileEditor::Between::follows)) return;
        for (std::size_t i = 0; i < meshes.size(); ++i)
            us[i].push_back(microsecondsOf(
                [&] { meshes[i]->refine(view, {.errorTolerancePx = methods[i].tolerancePx}); }));
    }
    for (std::size_t i = 0; i < meshes.size(); ++i)
    {
        methods[i].followsEdits = trueErrorPx(*meshes[i], *rivals.tile, view) <=
                                  2.0 * std::max(flight.errorPx, methods[i].tolerancePx);
        if (*methods[i].followsEdits) methods[i].editUs = measurement::percentile(us[i], 0.5);
    }
}

} // namespace terraintool
