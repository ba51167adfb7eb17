// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

#include <osgTerrainROAM/core/edit/TileEditor.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr int kGroupShift = 4; ///< log2 of the points, or samples, along a group of changes

/// Groups the points of an edit into tight rectangles of neighbours.
class Grouping
{
public:
    /// `step`: grid points to the next sample, up to which the surface has followed.
    void add(GridPoint p, int step)
    {
        const int shift = kGroupShift + std::bit_width(static_cast<unsigned>(step)) - 1;
        GridRect& rect = _rects[{step, p.row >> shift, p.column >> shift}];
        rect = rect.isEmpty() ? GridRect{p.column, p.row, p.column, p.row}
                              : GridRect{std::min(rect.west, p.column), std::min(rect.south, p.row),
                                         std::max(rect.east, p.column), std::max(rect.north, p.row)};
    }

    std::vector<ChangedPlaces> changed() const
    {
        std::vector<ChangedPlaces> all;
        for (const auto& [group, rect] : _rects)
            all.push_back({rect, std::get<0>(group)});
        return all;
    }

private:
    std::map<std::tuple<int, int, int>, GridRect> _rects; ///< by step and group
};

/// The rectangles in which vertices may have moved: between changed samples of the raster, too, and beyond
/// the edge of the data.
GridRect movedBy(const ChangedPlaces& changed, const PlacedTile& tile)
{
    GridRect moved = changed.rect.grownBy(changed.step - 1);
    if (changed.rect.east == tile.grid().dataColumns() - 1) moved.east = tile.grid().side() - 1;
    if (changed.rect.north == tile.grid().dataRows() - 1) moved.north = tile.grid().side() - 1;
    return moved;
}

std::string placeText(GridPoint p)
{
    return "column " + std::to_string(p.column) + ", row " + std::to_string(p.row);
}

} // namespace

foundation::Outcome TileEditor::check(std::span<const HeightChange> changes, Between between) const
{
    const PlacedTile& placed = _tile->tile;
    const auto refuse = [&](GridPoint p, const std::string& what, const std::string& remedy) {
        return foundation::Error{placed.field().name + ": " + placeText(p), what, remedy};
    };
    for (const HeightChange& change : changes)
    {
        const GridPoint p = change.place;
        if (p.column < 0 || p.row < 0 || !placed.grid().isInData(p.column, p.row))
            return refuse(p, "no place of the data", "edit within its edge");
        if (!placed.samples().isGround(p.column, p.row))
            return refuse(p, "a hole in the data", "edit where there is ground");
        if (!(std::abs(change.heightM) <= kHighestM))
            return refuse(p, "the height is no number or out of bounds", "stay within 20 km of zero");
        if (between == Between::follows && !placed.samples().hasSample(p.column, p.row))
            return refuse(p, "no sample is there", "put samples between others with Between::stays");
    }
    return foundation::success();
}

foundation::Result<EditReport> TileEditor::apply(std::span<const HeightChange> changes, Between between)
{
    const std::unique_lock lock(_tile->mutex());
    if (const auto sound = check(changes, between); !sound) return sound.error();
    EditReport report;
    Step step;
    if (between == Between::stays) surround(changes, step);
    write(changes, between, step, report);

    Grouping groups;
    for (const auto& [place, memo] : step.samples) // with the points around the changes: they count now
        if (!_tile->tile.grid().isOfRaster(place.column, place.row)) groups.add(place, 1);
    for (const HeightChange& change : changes)
    {
        const GridPoint p = change.place;
        groups.add(p, between == Between::follows ? _tile->tile.samples().sampleStep(p.column, p.row) : 1);
        _tile->include(p);
    }
    step.changed = groups.changed();
    step.movedM = report.largestChangeM;
    step.bounds = BoundsUpdate(*_tile).follow(step.changed, step.movedM);
    report.boundsChanged = step.bounds.size();
    note(step, step.bounds);
    _steps.push_back(std::move(step));
    return report;
}

void TileEditor::note(const Step& step, std::span<const BoundsUpdate::Change> bounds)
{
    TileChange change;
    for (const ChangedPlaces& places : step.changed)
        change.moved.push_back(movedBy(places, _tile->tile));
    for (const BoundsUpdate::Change& bound : bounds)
        change.vertices.push_back(bound.vertex);
    _tile->note(std::move(change));
}

/// Counts the points around added samples among the samples: the surface bends there, and beyond them it
/// stays as it is.
void TileEditor::surround(std::span<const HeightChange> changes, Step& step)
{
    PlacedTile& placed = _tile->tile;
    for (const HeightChange& change : changes)
        for (int row = change.place.row - 1; row <= change.place.row + 1; ++row)
            for (int column = change.place.column - 1; column <= change.place.column + 1; ++column)
            {
                if (column < 0 || row < 0 || !placed.grid().isInData(column, row) ||
                    placed.samples().hasSample(column, row) || !placed.samples().isGround(column, row))
                    continue;
                step.samples.emplace_back(GridPoint{column, row}, _tile->memo({column, row}));
                placed.samples().count(column, row);
            }
}

void TileEditor::write(std::span<const HeightChange> changes, Between between, Step& step, EditReport& report)
{
    PlacedTile& placed = _tile->tile;
    for (const HeightChange& change : changes)
    {
        const auto [column, row] = change.place;
        step.samples.emplace_back(change.place, _tile->memo(change.place));
        const double byM = std::abs(double{change.heightM} - placed.samples().heightM(column, row));
        report.largestChangeM = std::max(report.largestChangeM, byM);
        if (between == Between::follows && placed.samples().isMeasured(column, row))
            placed.samples().setSampleHeight(column, row, change.heightM);
        else
            placed.samples().setFineHeight(column, row, change.heightM);
    }
    report.samplesChanged = changes.size();
}

bool TileEditor::undo()
{
    if (_steps.empty()) return false;
    const std::unique_lock lock(_tile->mutex());
    Step step = std::move(_steps.back());
    _steps.pop_back();
    for (auto change = step.bounds.rbegin(); !step.boundsAreStale && change != step.bounds.rend(); ++change)
        _tile->restore(change->vertex, change->before);
    for (auto sample = step.samples.rbegin(); sample != step.samples.rend(); ++sample)
        _tile->restore(sample->first, sample->second);
    if (step.boundsAreStale) step.bounds = BoundsUpdate(*_tile).follow(step.changed, step.movedM);
    note(step, step.bounds);
    return true;
}

bool TileEditor::tighten(std::size_t mostSamples)
{
    const std::unique_lock lock(_tile->mutex());
    const auto changes = BoundsUpdate(*_tile).tighten(mostSamples);
    if (!changes.empty()) note({}, changes);
    for (Step& step : _steps)
        step.boundsAreStale = true;
    return _tile->looseVertices().empty();
}

} // namespace osgTerrainROAM::core
