// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgTerrainROAM/core/roam/BoundsUpdate.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

RoamTile::RoamTile(PlacedTile placedTile) : tile(std::move(placedTile)), regions(tile), hidingGround(tile)
{
    const ErrorTree measured(tile);
    const int step = tile.grid().cellSide();
    SampleIndex v = 0;
    for (int row = 0; row < tile.grid().side(); row += step)
        for (int column = 0; column < tile.grid().side(); column += step, ++v)
            if (tile.grid().isInData(column, row) || measured.errorM(v) > 0.0f)
                setBound({column, row}, measured.errorM(v), measured.radiusM(v));
    admitSheets();
}

void RoamTile::admitSheets()
{
    std::vector<ChangedPlaces> added;
    for (const SampleSheet& sheet : tile.samples().sheets())
    {
        added.push_back({sheet.inside(), sheet.step()});
        sheet.inside().forEachMultipleOf(sheet.step(),
                                         [this](int column, int row) {
                                             include({column, row});
                                         });
    }
    if (!added.empty()) BoundsUpdate(*this).admit(added);
}

void RoamTile::setBound(GridPoint v, float errorM, float radiusM)
{
    if (tile.grid().isInData(v.column, v.row))
        tile.samples().setBound(v.column, v.row, errorM, radiusM);
    else if (errorM > 0.0f)
        _beyond[keyOf(v)] = {errorM, radiusM};
    else
        _beyond.erase(keyOf(v));
}

float RoamTile::roundedUpError(GridPoint v, double errorM) const
{
    return tile.grid().isInData(v.column, v.row) ? tile.samples().roundedUpError(v.column, v.row, errorM)
                                                 : tile.samples().table().roundedUpError(errorM);
}

float RoamTile::roundedUpRadius(GridPoint v, double radiusM) const
{
    return tile.grid().isInData(v.column, v.row) ? tile.samples().roundedUpRadius(v.column, v.row, radiusM)
                                                 : tile.samples().table().roundedUpRadius(radiusM);
}

RoamTile::Memo RoamTile::memo(GridPoint v) const
{
    Memo memo;
    if (tile.grid().isInData(v.column, v.row))
    {
        memo.kept = tile.samples().kept(v.column, v.row);
        return memo;
    }
    const SplitBound bound = boundBeyond(v);
    memo.errorBeyondM = bound.errorM;
    memo.radiusBeyondM = bound.radiusM;
    return memo;
}

void RoamTile::restore(GridPoint v, const Memo& memo)
{
    if (tile.grid().isInData(v.column, v.row))
        tile.samples().restore(v.column, v.row, memo.kept);
    else
        setBound(v, memo.errorBeyondM, memo.radiusBeyondM);
}

void RoamTile::include(GridPoint v)
{
    regions.include(tile, v);
    hidingGround.include(tile.samples().heightM(v.column, v.row));
}

std::vector<GridPoint> RoamTile::looseVertices() const
{
    std::vector<GridPoint> vertices;
    for (const std::uint64_t key : _loose)
        vertices.push_back(placeOf(key));
    return vertices;
}

std::vector<GridPoint> RoamTile::verticesBeyond() const
{
    std::vector<GridPoint> vertices;
    for (const auto& [key, bound] : _beyond)
        vertices.push_back(placeOf(key));
    return vertices;
}

void RoamTile::setLoose(GridPoint v, bool loose)
{
    if (loose)
        _loose.insert(keyOf(v));
    else if (!_loose.empty())
        _loose.erase(keyOf(v));
}

std::optional<std::vector<const TileChange*>> RoamTile::changesSince(std::uint64_t revision) const
{
    const std::uint64_t missed = _revision - revision;
    if (missed > _changes.size()) return std::nullopt;
    std::vector<const TileChange*> changes;
    for (std::size_t i = _changes.size() - static_cast<std::size_t>(missed); i < _changes.size(); ++i)
        changes.push_back(&_changes[i]);
    return changes;
}

void RoamTile::note(TileChange change)
{
    const auto sizeOf = [](const TileChange& c) { return c.vertices.size() + c.moved.size() + 1; };
    ++_revision;
    _noted += sizeOf(change);
    _changes.push_back(std::move(change));
    while (_noted > kMostNoted && !_changes.empty())
    {
        _noted -= sizeOf(_changes.front());
        _changes.pop_front();
    }
}

SplitBound RoamTile::boundBeyond(GridPoint v) const
{
    const auto found = _beyond.find(keyOf(v));
    const Bound bound = found == _beyond.end() ? Bound{0.0f, 0.0f} : found->second;
    return {glm::vec3(tile.position(v.column, v.row)), bound.errorM, bound.radiusM};
}

} // namespace osgTerrainROAM::core
