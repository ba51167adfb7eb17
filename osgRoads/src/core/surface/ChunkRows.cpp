// SPDX-License-Identifier: Apache-2.0
#include "ChunkRows.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

namespace
{

constexpr std::size_t kMostRowSteps = 512;
constexpr double kAlongShare = 0.1;   ///< of a gap along the road, to one across it
constexpr double kLeastAreaM2 = 1e-9; ///< of a piece that has a normal

/// Returns how far a row lies from the straight pieces between two others. What lies along a piece, but not
/// at the place that s has there, moves the ends of dashes only; the outer edges of skirts, the first and the
/// last column, lie in the ground.
double gapBetween(const ChunkRow& row, const ChunkRow& before, const ChunkRow& after)
{
    const double share = (row.s - before.s) / (after.s - before.s);
    const std::vector<glm::dvec3>&here = row.places, &from = before.places, &to = after.places;
    double gap = 0.0;
    for (std::size_t i = 1; i + 1 < here.size(); ++i)
    {
        const glm::dvec3 way = to[i] - from[i], aside = here[i] - glm::mix(from[i], to[i], share);
        const double square = glm::dot(way, way), along = square > 0.0 ? glm::dot(aside, way) / square : 0.0;
        gap = std::max(
            {gap, glm::length(aside - along * way), kAlongShare * std::fabs(along) * std::sqrt(square)});
        if (i + 2 == here.size()) break;
        // On the diagonal that both triangles of a piece share: where a road twists they leave its surface
        // there.
        const glm::dvec3 off = share * (here[i] - to[i]) + (1.0 - share) * (here[i + 1] - from[i + 1]);
        const glm::dvec3 normal = glm::cross(to[i] - from[i], from[i + 1] - from[i]);
        const double length = glm::length(normal);
        if (length > kLeastAreaM2) gap = std::max(gap, std::fabs(glm::dot(off, normal)) / length);
    }
    return gap;
}

} // namespace

ChunkRows::ChunkRows(const PlacedNetwork& network, int road, const LaneSection& section,
                     const CrossSection& shape, const JunctionCover& cover, const RoadMeshSettings& settings)
    : _network(network), _road(road), _section(section), _shape(shape), _cover(cover), _settings(settings)
{
}

ChunkRow ChunkRows::rowAt(double s) const
{
    // At its end a section still has its own lanes.
    ChunkRow row;
    row.s = s;
    _shape.pointsAt(std::min(s, std::nextafter(_section.end, _section.s)), row.points);
    row.places.reserve(row.points.size());
    const RoadFrame frame = frameAt(_network.road(_road), s);
    for (const SectionPoint& point : row.points)
        row.places.push_back(_network.toScene({_road, s, point.t, point.h}, frame.pointAt(point.t, point.h)));
    return row;
}

double ChunkRows::gapAt(std::size_t row, std::size_t stride) const
{
    const std::size_t first = row / stride * stride, last = std::min(first + stride, _rows.size() - 1);
    return row == first ? 0.0 : gapBetween(_rows[row], _rows[first], _rows[last]);
}

/// Returns the greatest gap of rows in the middle of steps and, where those lie well, at their quarters: in
/// the middle of a bend to the left and one to the right a straight piece meets the surface.
double ChunkRows::gapOfSteps(double enoughM) const
{
    double gap = 0.0;
    for (std::size_t i = 1; i < _rows.size(); i += 2)
        gap = std::max(gap, gapAt(i, 2));
    for (std::size_t i = 1; i < _rows.size() && gap <= enoughM; i += 2)
    {
        const ChunkRow &before = _rows[i - 1], &after = _rows[i + 1];
        for (const double share : {0.25, 0.75})
            gap = std::max(gap, gapBetween(rowAt(std::lerp(before.s, after.s, share)), before, after));
    }
    return gap;
}

/// Whether other roads lie near the chunk whose first, middle and last rows are known.
bool ChunkRows::isNearOthers() const
{
    if (!_cover.canCover()) return false;
    constexpr double kBulge = 1.25, kMarginM = 1.0; // of widths between these rows
    double reachM = 0.0;
    for (const ChunkRow& row : _rows)
        reachM = std::max({reachM, std::fabs(row.points.front().t), std::fabs(row.points.back().t)});
    const double halfM = 0.5 * (_rows.back().s - _rows.front().s);
    return _cover.isNearOther(_rows[1].s, halfM + kBulge * reachM + kMarginM);
}

/// Returns the rows with one more in the middle of each two, which are evenly spaced.
std::vector<ChunkRow> ChunkRows::withMiddles(double from, double to)
{
    const auto steps = static_cast<double>(_rows.size() - 1);
    std::vector<ChunkRow> finer;
    for (std::size_t i = 0; i < _rows.size(); ++i)
    {
        if (i > 0)
            finer.push_back(rowAt(from + (to - from) * static_cast<double>(2 * i - 1) / (2.0 * steps)));
        finer.push_back(std::move(_rows[i]));
    }
    return finer;
}

/// Twice as many steps until every second row is near enough.
void ChunkRows::sample(double from, double to)
{
    _rows = {rowAt(from), rowAt(0.5 * (from + to)), rowAt(to)};
    _mayBeCovered = isNearOthers();
    const double longest = _mayBeCovered ? _settings.junctionStepM : _settings.chunkM;
    const double enoughM = _settings.errorM / kBetweenSamples;
    for (std::size_t steps = 1; steps < kMostRowSteps; steps *= 2)
    {
        const double step = (to - from) / static_cast<double>(steps);
        const bool isFine = step < 2.0 * _settings.shortestStepM || gapOfSteps(enoughM) <= enoughM;
        if (isFine && step <= longest) break;
        _rows = withMiddles(from, to);
    }
}

} // namespace osgRoads::core
