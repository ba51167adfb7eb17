// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

#include <foundation/ForEachAtOnce.h>

#include <osgTerrainROAM/core/roam/BoundsUpdate.h>
#include <osgTerrainROAM/core/roam/ErrorTree.h>
#include <osgTerrainROAM/core/roam/Outline.h>
#include <osgTerrainROAM/core/roam/TriangleSamples.h>

#include "SheetErrors.h"

namespace osgTerrainROAM::core
{

namespace
{

/// Finds the largest distance of samples from a triangle's plane; each is compared with the point of the
/// plane that has the same position in the grid.
class PlaneError
{
public:
    PlaneError(const PlacedTile& tile, const GridTriangle& t) : _tile(tile), _triangle(t)
    {
        const auto position = [&](GridPoint p) { return tile.position(p.column, p.row); };
        _origin = position(t.apex);
        _du = position(t.left) - _origin;
        _dw = position(t.right) - _origin;
    }

    void add(GridPoint p)
    {
        const auto b = _triangle.at(p.column, p.row);
        const glm::dvec3 error = _tile.position(p.column, p.row) - (_origin + _du * b.u + _dw * b.w);
        _largest2 = std::max(_largest2, glm::dot(error, error));
    }

    double largestM() const { return std::sqrt(_largest2); }

private:
    const PlacedTile& _tile;
    const GridTriangle& _triangle;
    glm::dvec3 _origin, _du, _dw;
    double _largest2 = 0.0;
};

constexpr std::size_t kRun = 128, kLeastRuns = 16; ///< of vertices that one thread measures in one go

/// Returns the first odd, or even, multiple of `half` that is not less than `from`.
int firstMultiple(int from, int half, bool odd)
{
    const int offset = odd ? half : 0;
    return ((from - offset + 2 * half - 1) & -(2 * half)) + offset;
}

} // namespace

std::vector<BoundsUpdate::Change> BoundsUpdate::follow(std::span<const ChangedPlaces> changed, double movedM)
{
    _changed = changed;
    _movedM = movedM;
    std::size_t places = 0;
    for (const ChangedPlaces& c : changed)
        places += static_cast<std::size_t>((c.rect.east - c.rect.west) / c.step + 1) *
                  static_cast<std::size_t>((c.rect.north - c.rect.south) / c.step + 1);
    _mostSamples = kScanFactor * (places + kScanFactor);
    return run();
}

void BoundsUpdate::admit(std::span<const ChangedPlaces> added)
{
    _changed = added;
    const SheetErrors errors(_tile.tile);
    _admitted = &errors;
    run();
    _admitted = nullptr;
}

std::vector<BoundsUpdate::Change> BoundsUpdate::tighten(std::size_t mostSamples)
{
    _changed = {};
    _mostSamples = std::numeric_limits<std::size_t>::max();
    std::vector<SplitDiamond> loose;
    for (const GridPoint v : _tile.looseVertices())
        loose.emplace_back(v, _tile.tile.grid().side());
    std::sort(loose.begin(), loose.end(),
              [](const SplitDiamond& a, const SplitDiamond& b) { return a.level() > b.level(); });
    std::size_t samples = 0;
    for (const SplitDiamond& diamond : loose)
    {
        if (samples > 0 && samples + samplesIn(diamond) > mostSamples) break;
        samples += samplesIn(diamond);
        _wanted[static_cast<std::size_t>(diamond.level())].push_back({diamond.vertex(), true});
    }
    return run();
}

std::vector<BoundsUpdate::Change> BoundsUpdate::run()
{
    for (int half = 1; half < _tile.tile.grid().side() - 1; half *= 2)
    {
        visitLevel(half, false);
        visitLevel(half, true);
    }
    return std::move(_changes);
}

void BoundsUpdate::visitLevel(int half, bool isCentre)
{
    const int fromFinest = 2 * (std::bit_width(static_cast<unsigned>(half)) - 1) + (isCentre ? 1 : 0);
    std::vector<Wanted> wanted;
    std::swap(wanted, _wanted[static_cast<std::size_t>(_tile.tile.grid().levels() - 1 - fromFinest)]);
    for (const ChangedPlaces& changed : _changed)
        collect(changed, half, isCentre, wanted);
    const auto key = [](const Wanted& w)
    { return std::tuple(w.vertex.row, w.vertex.column, !w.needsOwnError); }; // who needs more comes first
    std::sort(wanted.begin(), wanted.end(),
              [&](const Wanted& a, const Wanted& b) { return key(a) < key(b); });
    const auto isSame = [](const Wanted& a, const Wanted& b) { return a.vertex == b.vertex; };
    wanted.erase(std::unique(wanted.begin(), wanted.end(), isSame), wanted.end());
    const std::vector<double> measured = measuredAtOnce(wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        visit(wanted[i], measured[i]);
}

/// Measures the diamonds that are small enough, in several threads where there are many: no vertex of a level
/// changes what is measured of another. NaN: not measured.
std::vector<double> BoundsUpdate::measuredAtOnce(const std::vector<Wanted>& wanted) const
{
    std::vector<double> measured(wanted.size(), std::numeric_limits<double>::quiet_NaN());
    if (_admitted) return measured;
    const auto measure = [&](std::size_t run)
    {
        for (std::size_t i = run * kRun; i < std::min((run + 1) * kRun, wanted.size()); ++i)
        {
            const SplitDiamond diamond(wanted[i].vertex, _tile.tile.grid().side());
            if (wanted[i].needsOwnError && isSmall(diamond)) measured[i] = measuredM(diamond);
        }
    };
    const std::size_t runs = (wanted.size() + kRun - 1) / kRun;
    if (runs >= kLeastRuns) // an edit of a few places, beside frames that are drawn, keeps to its thread
        foundation::forEachAtOnce(runs, measure);
    else
        for (std::size_t run = 0; run < runs; ++run)
            measure(run);
    return measured;
}

/// Collects the vertices of a level whose diamonds touch changed samples. On a level finer than the changed
/// samples only samples of sheets, samples that edits have added between them, and vertices beside these can
/// have an error.
void BoundsUpdate::collect(const ChangedPlaces& changed, int half, bool isCentre,
                           std::vector<Wanted>& wanted) const
{
    GridRect around = changed.rect.grownBy(std::max(half, changed.step));
    // Beyond the data's edge lie vertices that have moved with it, and above them are others.
    if (changed.rect.east == _tile.tile.grid().dataColumns() - 1) around.east += half;
    if (changed.rect.north == _tile.tile.grid().dataRows() - 1) around.north += half;
    if (half >= changed.step) return collectIn(around, half, isCentre, wanted);
    for (const SampleSheet& sheet : _tile.tile.samples().sheets())
        if (half >= sheet.step())
            collectIn(around.cutTo(sheet.rect().grownBy(2 * half)), half, isCentre, wanted);
    _tile.tile.samples().fineSamples().forEachIn(
        around.cutTo({0, 0, _tile.tile.grid().side() - 1, _tile.tile.grid().side() - 1}),
        [&](int column, int row) {
            collectIn(GridRect{column, row, column, row}.grownBy(half), half, isCentre, wanted);
        });
}

void BoundsUpdate::collectIn(const GridRect& rect, int half, bool isCentre, std::vector<Wanted>& wanted) const
{
    const int last = _tile.tile.grid().side() - 1;
    const GridRect around = rect.cutTo({0, 0, last, last});
    const int firstRow =
        isCentre ? firstMultiple(around.south, half, true) : (around.south + half - 1) & -half;
    for (int row = firstRow; row <= around.north; row += isCentre ? 2 * half : half)
    {
        const bool oddColumns = isCentre || (row / half) % 2 == 0;
        for (int column = firstMultiple(around.west, half, oddColumns); column <= around.east;
             column += 2 * half)
            wanted.push_back({{column, row}, true});
    }
}

void BoundsUpdate::visit(const Wanted& wanted, double measuredM)
{
    const GridPoint v = wanted.vertex;
    const PlacedTile& placed = _tile.tile;
    const SplitDiamond diamond(v, placed.grid().side());
    const SplitBound before = _tile.bound(v);
    double error = wanted.needsOwnError ? ownErrorM(diamond, before.errorM, measuredM) : before.errorM;
    const glm::dvec3 centre = before.centre; // as the predicate sees the vertex
    double radius = glm::distance(centre, placed.position(v.column, v.row));
    bool isAbove =
        placed.samples().hasSample(v.column, v.row); // has something that counts below it, or may have
    diamond.forEachChild(
        [&](GridPoint c)
        {
            const SplitBound child = _tile.bound(c);
            if (child.errorM <= 0.0f && !placed.samples().hasSample(c.column, c.row)) return;
            isAbove = true;
            error = std::max<double>(error, child.errorM);
            radius = std::max(radius, glm::distance(centre, glm::dvec3(child.centre)) + child.radiusM);
        });
    if (!isAbove && error <= 0.0 && before.errorM <= 0.0f) return;
    SplitBound after = before;
    after.errorM = _tile.roundedUpError(v, error);
    after.radiusM = _tile.roundedUpRadius(v, radius * ErrorTree::kRadiusSlack);
    if (after.errorM != before.errorM || after.radiusM != before.radiusM) propagate(diamond, before, after);
}

void BoundsUpdate::propagate(const SplitDiamond& diamond, const SplitBound& before, const SplitBound& after)
{
    const GridPoint v = diamond.vertex();
    if (!_admitted) _changes.push_back({v, _tile.memo(v)});
    _tile.setBound(v, after.errorM, after.radiusM);
    diamond.forEachParent(
        [&](GridPoint p)
        {
            // The parent's bound may come from this vertex.
            const bool mayFall = after.errorM < before.errorM &&
                                 _tile.roundedUpError(p, before.errorM) >= _tile.bound(p).errorM;
            _wanted[static_cast<std::size_t>(diamond.level() - 1)].push_back({p, mayFall});
        });
}

std::size_t BoundsUpdate::samplesIn(const SplitDiamond& diamond) const
{
    const auto across = static_cast<std::size_t>(2 * diamond.half());
    const std::size_t places = across * across, ofRaster = places >> (2 * _tile.tile.grid().exponent());
    std::size_t samples = ofRaster + std::min(places, _tile.tile.samples().fineSamples().sampleSpace());
    for (const SampleSheet& sheet : _tile.tile.samples().sheets())
        samples += std::min(places, sheet.table().size());
    return samples;
}

bool BoundsUpdate::isSmall(const SplitDiamond& diamond) const
{
    return samplesIn(diamond) <= _mostSamples;
}

/// `measuredM`: its error, where it was small when its level began.
double BoundsUpdate::ownErrorM(const SplitDiamond& diamond, double beforeM, double measuredM)
{
    if (_admitted)
    {
        diamond.forEachTriangle([&](const GridTriangle& t)
                                { beforeM = std::max(beforeM, _admitted->largestM(t)); });
        return beforeM;
    }
    const bool isStillSmall = isSmall(diamond); // bounds that are kept only add to the samples' space
    _tile.setLoose(diamond.vertex(), !isStillSmall);
    return isStillSmall ? measuredM : boundM(diamond, beforeM);
}

double BoundsUpdate::measuredM(const SplitDiamond& diamond) const
{
    double largest = 0.0;
    diamond.forEachTriangle(
        [&](const GridTriangle& t)
        {
            PlaneError error(_tile.tile, t);
            forEachSampleIn(_tile.tile, t, [&](GridPoint p) { error.add(p); });
            largest = std::max({largest, error.largestM(), outlineErrorM(_tile.tile, t)});
        });
    return largest;
}

double BoundsUpdate::boundM(const SplitDiamond& diamond, double beforeM) const
{
    const PlacedTile& placed = _tile.tile;
    bool cornerMoved = false;
    double changedM = 0.0, fromChildren = 0.0, outlineM = 0.0;
    diamond.forEachTriangle(
        [&](const GridTriangle& t)
        {
            cornerMoved = cornerMoved || hasMoved(t.apex) || hasMoved(t.left) || hasMoved(t.right);
            changedM = std::max(changedM, changedErrorM(t));
            outlineM = std::max(outlineM, outlineErrorM(placed, t));
        });
    const double fromBefore = std::max(beforeM + (cornerMoved ? _movedM : 0.0), changedM);
    diamond.forEachChild([&](GridPoint c)
                         { fromChildren = std::max<double>(fromChildren, _tile.bound(c).errorM); });
    const auto position = [&](GridPoint p) { return placed.position(p.column, p.row); };
    const auto [a, b] = diamond.baseEnds();
    fromChildren += glm::distance(position(diamond.vertex()), 0.5 * (position(a) + position(b)));
    return std::max(std::min(fromBefore, fromChildren), outlineM);
}

/// Of the samples that have changed.
double BoundsUpdate::changedErrorM(const GridTriangle& triangle) const
{
    PlaneError error(_tile.tile, triangle);
    for (const ChangedPlaces& changed : _changed)
        _tile.tile.samples().forEachSample(changed.rect.cutTo(triangle.extent()),
                                           [&](int column, int row)
                                           {
                                               if (triangle.holds({column, row})) error.add({column, row});
                                           });
    return error.largestM();
}

bool BoundsUpdate::hasMoved(GridPoint corner) const
{
    const int column = std::min(corner.column, _tile.tile.grid().dataColumns() - 1);
    const int row = std::min(corner.row, _tile.tile.grid().dataRows() - 1);
    return std::any_of(_changed.begin(), _changed.end(),
                       [&](const ChangedPlaces& changed) { return changed.rect.holds(column, row); });
}

} // namespace osgTerrainROAM::core
