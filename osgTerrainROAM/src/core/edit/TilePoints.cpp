// SPDX-License-Identifier: Apache-2.0
#include "TilePoints.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <tuple>

#include <osgTerrainROAM/core/edit/EditFile.h>

namespace osgTerrainROAM::core
{

namespace
{

bool isSameSample(const SampleTable::Sample& a, const SampleTable::Sample& b)
{
    return std::memcmp(&a, &b, sizeof(a)) == 0;
}

/// The bounds of a vertex beyond the data; its height is no part of them.
SampleTable::Sample boundBeyond(const RoamTile& tile, GridPoint v)
{
    const SplitBound bound = tile.bound(v);
    return {0.0f, bound.errorM, bound.radiusM};
}

PointState stateOf(const RoamTile& tile, GridPoint v)
{
    const auto kept = tile.tile.samples().kept(v.column, v.row);
    return {v, kept.inTable, kept.inSheet, kept.isElsewhere};
}

/// Adds those measured points that have changed.
void addMeasured(const RoamTile& before, const RoamTile& edited, std::vector<PointState>& points)
{
    const auto look = [&](int column, int row)
    {
        const PointState state = stateOf(edited, {column, row}), old = stateOf(before, {column, row});
        if (state.isElsewhere != old.isElsewhere || !isSameSample(state.bound, old.bound) ||
            !isSameSample(state.inSheet, old.inSheet))
            points.push_back(state);
    };
    const TileGrid& grid = edited.tile.grid();
    grid.dataRect().forEachMultipleOf(grid.cellSide(), look);
    for (const SampleSheet& sheet : edited.tile.samples().sheets())
        sheet.inside().forEachMultipleOf(sheet.step(), look);
}

void addBeyond(const RoamTile& before, const RoamTile& edited, std::vector<PointState>& points)
{
    std::vector<GridPoint> places = before.verticesBeyond();
    for (const GridPoint v : edited.verticesBeyond())
        places.push_back(v);
    for (const GridPoint v : places)
        if (const auto bound = boundBeyond(edited, v); !isSameSample(bound, boundBeyond(before, v)))
            points.push_back({v, bound});
}

} // namespace

bool ChunkState::isWithin(const TileGrid& grid) const
{
    constexpr int kInChunk = FineSamples::kChunkSide - 1;
    return place.column >= 0 && place.row >= 0 && (place.column & kInChunk) == 0 &&
           (place.row & kInChunk) == 0 && place.column < grid.dataColumns() && place.row < grid.dataRows();
}

std::array<SampleTable::Sample, ChunkState::kPoints> ChunkState::emptySamples()
{
    std::array<SampleTable::Sample, kPoints> samples;
    samples.fill({FineSamples::kNoHeight, 0.0f, 0.0f});
    return samples;
}

std::vector<PointState> changedPoints(const RoamTile& before, const RoamTile& edited)
{
    std::vector<PointState> points;
    addMeasured(before, edited, points);
    addBeyond(before, edited, points);
    const auto isInData = [&](GridPoint v) { return edited.tile.grid().isInData(v.column, v.row); };
    for (const GridPoint v : edited.looseVertices())
    {
        PointState state = isInData(v) ? stateOf(edited, v) : PointState{v, boundBeyond(edited, v)};
        state.isLoose = true;
        points.push_back(state);
    }
    const auto order = [](const PointState& p)
    { return std::tuple(p.place.row, p.place.column, !p.isLoose); };
    std::sort(points.begin(), points.end(),
              [&](const PointState& a, const PointState& b) { return order(a) < order(b); });
    const auto isOne = [](const PointState& a, const PointState& b)
    { return a.place.row == b.place.row && a.place.column == b.place.column; };
    points.erase(std::unique(points.begin(), points.end(), isOne), points.end());
    return points;
}

std::vector<ChunkState> chunksOf(const RoamTile& edited)
{
    std::vector<ChunkState> chunks;
    for (const auto& [column, row] : edited.tile.samples().fineSamples().chunkPlaces())
    {
        ChunkState chunk;
        chunk.place = {column, row};
        for (std::size_t slot = 0; slot < ChunkState::kPoints; ++slot)
        {
            const int inColumn = static_cast<int>(slot) % FineSamples::kChunkSide;
            const int inRow = static_cast<int>(slot) / FineSamples::kChunkSide;
            const auto* sample = edited.tile.samples().fineSamples().find(column + inColumn, row + inRow);
            if (sample) chunk.samples[slot] = *sample;
        }
        chunks.push_back(chunk);
    }
    return chunks;
}

bool isInTree(const RoamTile& tile, GridPoint place)
{
    const int side = tile.tile.grid().side();
    return place.column >= 0 && place.row >= 0 && place.column < side && place.row < side;
}

void restorePoints(RoamTile& tile, std::span<const PointState> points)
{
    for (const PointState& point : points)
    {
        const GridPoint v = point.place;
        if (!tile.tile.grid().isInData(v.column, v.row))
            tile.setBound(v, point.bound.errorM, point.bound.radiusM);
        else if (tile.tile.samples().isMeasured(v.column, v.row))
        {
            auto kept = tile.tile.samples().kept(v.column, v.row);
            if (kept.isInTable) kept.inTable = point.bound;
            if (kept.isInSheet) kept.inSheet = point.inSheet;
            kept.isElsewhere = point.isElsewhere;
            tile.tile.samples().restore(v.column, v.row, kept);
        }
        if (point.isLoose) tile.setLoose(v, true);
    }
}

void restoreChunk(RoamTile& tile, const ChunkState& chunk)
{
    tile.tile.samples().setFineChunk(chunk.place.column, chunk.place.row, chunk.samples);
}

std::uint64_t markOfTile(const RoamTile& tile)
{
    const TileGrid& grid = tile.tile.grid();
    const Geodetic origin = tile.tile.frame().origin();
    std::vector<double> facts{static_cast<double>(grid.side()),
                              static_cast<double>(grid.dataColumns()),
                              static_cast<double>(grid.dataRows()),
                              static_cast<double>(grid.exponent()),
                              tile.tile.field().spacingEastM,
                              tile.tile.field().spacingNorthM,
                              origin.latitudeDeg,
                              origin.longitudeDeg,
                              origin.heightM,
                              static_cast<double>(tile.regions.spheres().size())};
    const auto bytes = [](const auto& values)
    {
        return std::string_view(reinterpret_cast<const char*>(values.data()),
                                values.size() * sizeof(values.front()));
    };
    std::uint64_t mark = markOf(bytes(facts));
    constexpr std::size_t kAtOnce = 4096; // whole words of markOf()
    std::vector<SampleTable::Sample> samples;
    const auto add = [&](const SampleTable& table)
    {
        for (std::size_t i = 0; i < table.size(); ++i)
        {
            samples.push_back(table.sample(i));
            if (samples.size() < kAtOnce) continue;
            mark = markOf(bytes(samples), mark);
            samples.clear();
        }
    };
    add(tile.tile.samples().table());
    for (const SampleSheet& sheet : tile.tile.samples().sheets())
        add(sheet.table());
    return markOf(bytes(samples), mark);
}

} // namespace osgTerrainROAM::core
