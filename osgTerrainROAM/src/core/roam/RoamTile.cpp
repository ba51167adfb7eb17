// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <foundation/KeptResults.h>
#include <foundation/PlainBytes.h>

#include <osgTerrainROAM/core/heightfield/SampleRaster.h>
#include <osgTerrainROAM/core/roam/BoundsUpdate.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Everything that the bounds of a tile follow from, while it has neither edits nor dense parts.
foundation::ContentMark markOf(const PlacedTile& tile)
{
    const TileGrid& grid = tile.grid();
    const SampleTable& table = tile.samples().table();
    const Geodetic origin = tile.frame().origin();
    foundation::ContentMark mark;
    for (const int count : {grid.side(), grid.dataColumns(), grid.dataRows(), grid.exponent(),
                            static_cast<int>(tile.frame().placement())})
        mark.addWord(static_cast<std::uint64_t>(count));
    mark.add(std::vector<double>{tile.field().spacingEastM, tile.field().spacingNorthM, origin.latitudeDeg,
                                 origin.longitudeDeg, origin.heightM, table.heightQuantumM()});
    if (const auto& net = tile.field().net)
        mark.addWord(static_cast<std::uint64_t>(net->step)).add(net->nodes);
    constexpr std::size_t kAtOnce = 4096;
    std::vector<float> heightsM;
    for (std::size_t first = 0; first < table.size(); first += kAtOnce)
    {
        heightsM.resize(std::min(kAtOnce, table.size() - first));
        for (std::size_t i = 0; i < heightsM.size(); ++i)
            heightsM[i] = table.heightM(first + i);
        mark.add(heightsM);
    }
    const SampleRaster raster(tile);
    std::vector<std::uint8_t> isThere;
    for (int row = 0; row < raster.dataRows() && tile.samples().hasHoles(); ++row)
        for (int column = 0; column < raster.dataColumns(); ++column)
            isThere.push_back(tile.samples().mask().holds(column, row) ? 1 : 0);
    return mark.add(isThere);
}

} // namespace

RoamTile::RoamTile(PlacedTile placedTile, const foundation::KeptResults* kept)
    : tile(std::move(placedTile)), regions(tile), hidingGround(tile)
{
    if (!kept || !tile.samples().sheets().empty())
        measureBounds();
    else
    {
        _mark = markOf(tile);
        const auto take = [&](std::string_view bytes)
        { return takeBounds(bytes) ? std::optional(true) : std::nullopt; };
        const auto measure = [&]
        {
            measureBounds();
            return true;
        };
        kept->findOrMake("bounds", *_mark, take, measure, [&](bool) { return boundBytes(); });
    }
    admitSheets();
}

void RoamTile::measureBounds()
{
    regions.fit(tile);
    const ErrorTree measured(tile);
    const int step = tile.grid().cellSide();
    SampleIndex v = 0;
    for (int row = 0; row < tile.grid().side(); row += step)
        for (int column = 0; column < tile.grid().side(); column += step, ++v)
            if (tile.grid().isInData(column, row) || measured.errorM(v) > 0.0f)
                setBound({column, row}, measured.errorM(v), measured.radiusM(v));
}

/// The bounds of the raster's samples, then those beyond the data, then the regions' spheres.
std::string RoamTile::boundBytes() const
{
    const SampleTable& table = tile.samples().table();
    std::vector<Bound> bounds(table.size());
    for (std::size_t i = 0; i < bounds.size(); ++i)
    {
        const SampleTable::Sample sample = table.sample(i);
        bounds[i] = {sample.errorM, sample.radiusM};
    }
    std::vector<std::uint64_t> keys;
    for (const auto& [key, bound] : _beyond)
        keys.push_back(key);
    std::sort(keys.begin(), keys.end());
    std::vector<Bound> beyond;
    for (const std::uint64_t key : keys)
        beyond.push_back(_beyond.at(key));
    std::string bytes;
    foundation::appendText(bytes,
                           {reinterpret_cast<const char*>(bounds.data()), bounds.size() * sizeof(Bound)});
    foundation::appendValues(bytes, keys);
    foundation::appendValues(bytes, beyond);
    const auto spheres = regions.spheres();
    foundation::appendValues(bytes, std::vector(spheres.begin(), spheres.end()));
    return bytes;
}

/// False, and nothing is changed: the bytes are not what boundBytes() wrote.
bool RoamTile::takeBounds(std::string_view bytes)
{
    foundation::ValueTaker taker(bytes);
    std::string_view bounds; // read where they lie: they are many
    std::vector<Bound> beyond;
    std::vector<std::uint64_t> keys;
    std::vector<RegionBounds::Sphere> spheres;
    if (!taker.take(bounds) || !taker.take(keys) || !taker.take(beyond) || !taker.take(spheres) ||
        !taker.isEmpty())
        return false;
    const std::size_t count = tile.samples().table().size();
    if (bounds.size() != count * sizeof(Bound) || keys.size() != beyond.size() ||
        spheres.size() != regions.spheres().size())
        return false;
    const auto boundAt = [&](std::size_t i)
    {
        Bound bound;
        std::memcpy(&bound, bounds.data() + i * sizeof bound, sizeof bound);
        return bound;
    };
    const auto isBound = [](const Bound& bound) { return bound.errorM >= 0.0f && bound.radiusM >= 0.0f; };
    const auto isSphere = [](const RegionBounds::Sphere& sphere)
    {
        return std::isfinite(sphere.centre.x + sphere.centre.y + sphere.centre.z + sphere.highestM) &&
               sphere.radiusM >= 0.0;
    };
    const auto isBeyond = [&](std::uint64_t key)
    {
        const GridPoint v = placeOf(key);
        return v.column >= 0 && v.row >= 0 && v.column < tile.grid().side() && v.row < tile.grid().side() &&
               !tile.grid().isInData(v.column, v.row);
    };
    for (std::size_t n = 0; n < count; ++n)
        if (!isBound(boundAt(n))) return false;
    if (!std::all_of(beyond.begin(), beyond.end(), isBound) ||
        !std::all_of(keys.begin(), keys.end(), isBeyond) ||
        !std::all_of(spheres.begin(), spheres.end(), isSphere))
        return false;
    regions.setSpheres(spheres);
    const int step = tile.grid().cellSide();
    std::size_t i = 0;
    for (int row = 0; row < tile.grid().dataRows(); row += step)
        for (int column = 0; column < tile.grid().dataColumns(); column += step, ++i)
        {
            const Bound bound = boundAt(i);
            tile.samples().setBound(column, row, bound.errorM, bound.radiusM);
        }
    for (std::size_t k = 0; k < keys.size(); ++k)
        _beyond[keys[k]] = beyond[k];
    return true;
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
