// SPDX-License-Identifier: Apache-2.0
#include "ChunkBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <osgRoads/core/place/TunnelTube.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

namespace
{

constexpr std::size_t kMostSteps = 512;
constexpr double kSlopeStepM = 0.02; ///< for the direction along the road
/// Errors are measured at samples: between them a smooth curve departs by little more.
constexpr double kBetweenSamples = 1.15;
constexpr double kAlongShare = 0.1;   ///< of a gap along the road, to one across it
constexpr double kLeastAreaM2 = 1e-9; ///< of a piece that has a normal
/// Half a step in each coordinate.
constexpr double kRoundingM = 0.87 * RoadMesh::kMeshStepM;

/// Whether a surface is painted on.
bool isPaved(SurfaceKind kind)
{
    return kind == SurfaceKind::asphalt || kind == SurfaceKind::concrete || kind == SurfaceKind::shoulder;
}

std::array<std::int8_t, 4> packed(const glm::dvec3& normal)
{
    std::array<std::int8_t, 4> bytes{};
    for (int i = 0; i < 3; ++i)
        bytes[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(std::lround(127.0 * normal[i]));
    return bytes;
}

} // namespace

ChunkBuilder::ChunkBuilder(const PlacedNetwork& network, int road, const LaneSection& section,
                           const OpenEnds& ends, const RoadMeshSettings& settings, MarkRows& marks,
                           DecalRows& decals, RoadMesh& mesh)
    : _network(network),
      _road(road),
      _section(section),
      _ends(ends),
      _settings(settings),
      _shape(network.road(road), section, settings.bed),
      _cover(network, road),
      _marks(marks),
      _decals(decals),
      _mesh(mesh)
{
}

ChunkBuilder::Row ChunkBuilder::rowAt(double s) const
{
    // At its end a section still has its own lanes.
    Row row;
    row.s = s;
    _shape.pointsAt(std::min(s, std::nextafter(_section.end, _section.s)), row.points);
    row.places.reserve(row.points.size());
    const RoadFrame frame = frameAt(_network.road(_road), s);
    for (const SectionPoint& point : row.points)
        row.places.push_back(_network.toScene({_road, s, point.t, point.h}, frame.pointAt(point.t, point.h)));
    return row;
}

/// Returns how far a row lies from the straight pieces between two others. What lies along a piece, but not at the place that s
/// has there, moves the ends of dashes only; the outer edges of skirts, the first and the last column, lie in the ground.
double ChunkBuilder::gapBetween(const Row& row, const Row& before, const Row& after)
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
        // On the diagonal that both triangles of a piece share: where a road twists they leave its surface there.
        const glm::dvec3 off = share * (here[i] - to[i]) + (1.0 - share) * (here[i + 1] - from[i + 1]);
        const glm::dvec3 normal = glm::cross(to[i] - from[i], from[i + 1] - from[i]);
        const double length = glm::length(normal);
        if (length > kLeastAreaM2) gap = std::max(gap, std::fabs(glm::dot(off, normal)) / length);
    }
    return gap;
}

/// Returns how far a row lies from the level that keeps every `stride`th one.
double ChunkBuilder::gapAt(std::size_t row, std::size_t stride) const
{
    const std::size_t first = row / stride * stride, last = std::min(first + stride, _rows.size() - 1);
    return row == first ? 0.0 : gapBetween(_rows[row], _rows[first], _rows[last]);
}

/// Returns the greatest gap of rows in the middle of steps and, where those lie well, at their quarters: in the middle of a bend to
/// the left and one to the right a straight piece meets the surface.
double ChunkBuilder::gapOfSteps(double enoughM) const
{
    double gap = 0.0;
    for (std::size_t i = 1; i < _rows.size(); i += 2)
        gap = std::max(gap, gapAt(i, 2));
    for (std::size_t i = 1; i < _rows.size() && gap <= enoughM; i += 2)
    {
        const Row &before = _rows[i - 1], &after = _rows[i + 1];
        for (const double share : {0.25, 0.75})
            gap = std::max(gap, gapBetween(rowAt(std::lerp(before.s, after.s, share)), before, after));
    }
    return gap;
}

/// Whether other roads lie near the chunk whose first, middle and last rows are known.
bool ChunkBuilder::mayBeCovered() const
{
    if (!_cover.canCover()) return false;
    constexpr double kBulge = 1.25, kMarginM = 1.0; // of widths between these rows
    double reachM = 0.0;
    for (const Row& row : _rows)
        reachM = std::max({reachM, std::fabs(row.points.front().t), std::fabs(row.points.back().t)});
    const double halfM = 0.5 * (_rows.back().s - _rows.front().s);
    return _cover.isNearOther(_rows[1].s, halfM + kBulge * reachM + kMarginM);
}

/// Fills _rows: twice as many steps until every second row is near enough.
void ChunkBuilder::sample(double from, double to)
{
    _rows = {rowAt(from), rowAt(0.5 * (from + to)), rowAt(to)};
    _mayBeCovered = mayBeCovered();
    const double longest = _mayBeCovered ? _settings.junctionStepM : _settings.chunkM;
    for (std::size_t steps = 1; steps < kMostSteps; steps *= 2)
    {
        const double step = (to - from) / static_cast<double>(steps);
        const double enoughM = _settings.errorM / kBetweenSamples;
        const bool isFine = step < 2.0 * _settings.shortestStepM || gapOfSteps(enoughM) <= enoughM;
        if (isFine && step <= longest) break;
        std::vector<Row> finer;
        for (std::size_t i = 0; i < _rows.size(); ++i)
        {
            if (i > 0)
                finer.push_back(rowAt(from + (to - from) * static_cast<double>(2 * i - 1) /
                                                 static_cast<double>(4 * steps)));
            finer.push_back(std::move(_rows[i]));
        }
        _rows = std::move(finer);
    }
}

/// Returns the pieces of a strip between the rows of the finest level.
std::vector<SurfaceQuad> ChunkBuilder::quadsOf(std::size_t firstColumn, std::size_t columns) const
{
    std::vector<SurfaceQuad> quads;
    const std::size_t last = firstColumn + columns - 1;
    for (std::size_t i = 0; i + 2 < _rows.size(); i += 2)
        quads.push_back({_rows[i].places[firstColumn], _rows[i + 2].places[firstColumn],
                         _rows[i + 2].places[last], _rows[i].places[last]});
    return quads;
}

/// Whether most of a verge, of which a column is the outer edge, is a gap within a junction.
bool ChunkBuilder::isGap(std::size_t column, int side) const
{
    constexpr std::size_t kAsked = 5; // rows
    std::size_t gaps = 0;
    for (std::size_t i = 0; i < kAsked; ++i)
    {
        const Row& row = _rows[i * (_rows.size() - 1) / (kAsked - 1)];
        gaps += _cover.isGap(row.s, row.points[column].t, side) ? 1 : 0;
    }
    return 2 * gaps > kAsked;
}

/// Returns what the vertices of each strip have in common.
std::vector<MeshVertex> ChunkBuilder::stripsAt(double from, bool hasGround) const
{
    std::vector<MeshVertex> strips;
    std::size_t first = 0;
    for (const Strip& strip : _shape.strips())
    {
        const auto columns = static_cast<std::size_t>(strip.columns);
        MeshVertex vertex;
        const bool isOnDeck = strip.lane && isGround(strip.kind) && !hasGround;
        vertex.kind = isOnDeck ? SurfaceKind::shoulder : strip.kind; // no grass on bridges and in tunnels
        if (isPaved(vertex.kind)) vertex.decalRow = _decals.listFor(quadsOf(first, columns));
        // Nobody leaves wedges of grass between the lanes of a junction.
        const bool isRight = first < 4, isVerge = strip.isBesideLanes() && strip.kind != SurfaceKind::skirt;
        if (isVerge && _mayBeCovered && _cover.canCoverMarks() &&
            isGap(isRight ? first : first + 1, isRight ? -1 : 1))
            vertex.kind = SurfaceKind::asphalt;
        first += columns;
        if (strip.rightMark) vertex.rightRow = _marks.rowOf(_section, *strip.rightMark, from);
        if (strip.leftMark) vertex.leftRow = _marks.rowOf(_section, *strip.leftMark, from);
        strips.push_back(vertex);
    }
    return strips;
}

/// Whether a lane lies outside of the tube that the paved lanes have: there is hillside, which stays as it is.
bool ChunkBuilder::isOutsideOfTunnel(const Lane& lane, const Row& row) const
{
    if (!_isInTunnel || lane.type != LaneType::none) return false;
    const double s = std::min(row.s, std::nextafter(_section.end, _section.s));
    const auto span = laneSpan(_network.road(_road), lane.id, s);
    const RoadSides paved = pavedSides(_network.road(_road), s);
    return span && (lane.id > 0 ? span->innerT >= paved.left : span->innerT <= paved.right);
}

void ChunkBuilder::addRow(const Row& row, double from, bool hasGround, const std::vector<MeshVertex>& strips)
{
    const double ahead = row.s + kSlopeStepM < _section.end ? kSlopeStepM : -kSlopeStepM;
    const Row other = rowAt(row.s + ahead);
    const auto wear = static_cast<std::int8_t>(std::lround(127.0 * _ends.wearAt(row.s)));
    // Two strips share a border, where the answer is the same.
    double askedT = std::numeric_limits<double>::quiet_NaN();
    bool isAskedCovered = false;
    JunctionCover::By askedBy = JunctionCover::By::carriageway;
    const auto isCovered = [&](double t, JunctionCover::By by)
    {
        if ((t == askedT && by == askedBy) || !_mayBeCovered) return isAskedCovered;
        askedT = t;
        askedBy = by;
        return isAskedCovered = _cover.covers(row.s, t, by);
    };
    std::size_t first = 0;
    for (std::size_t i = 0; i < strips.size(); ++i)
    {
        const Strip& strip = _shape.strips()[i];
        const auto count = static_cast<std::size_t>(strip.columns);
        const bool isOwnCarriageway = strip.lane && isForCars(strip.lane->type);
        const bool isAsked = !isOwnCarriageway || _cover.canCoverMarks();
        const bool isOutsideOfTube =
            strip.lane && isGround(strip.kind) && isOutsideOfTunnel(*strip.lane, row);
        const auto by = strip.isBesideLanes() ? JunctionCover::By::paving : JunctionCover::By::carriageway;
        const bool rightCovered = isAsked && isCovered(row.points[first].t, by);
        const bool leftCovered = isAsked && isCovered(row.points[first + count - 1].t, by);
        for (std::size_t j = first; j < first + count; ++j)
        {
            MeshVertex vertex = strips[i];
            const glm::dvec3 steps = glm::round((row.places[j] - _mesh.origin) / RoadMesh::kMeshStepM);
            for (int axis = 0; axis < 3; ++axis)
                vertex.position[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(steps[axis]);
            vertex.s = static_cast<float>(row.s - from);
            vertex.across = static_cast<float>(row.points[j].across);
            vertex.width = static_cast<float>(row.points[j].width);
            // A skirt is lit as the verge beside it: its own slope would show as a line where the ground begins.
            const bool isSkirt = strip.kind == SurfaceKind::skirt;
            const std::size_t verge = first == 0 ? count : first - 2; // beside a skirt, of two columns
            const std::size_t a = isSkirt ? verge : j > first ? j - 1 : j;
            const std::size_t b = isSkirt ? verge + 1 : j + 1 < first + count ? j + 1 : j;
            const glm::dvec3 normal =
                glm::cross((other.places[j] - row.places[j]) / ahead, row.places[b] - row.places[a]);
            const double length = glm::length(normal);
            vertex.normal = packed(length > 1e-9 ? normal / length : glm::dvec3(0.0, 0.0, 1.0));
            vertex.normal[3] = wear;
            if (!isOwnCarriageway && (j == first + count - 1 ? leftCovered : rightCovered))
                vertex.present = 0;
            if ((strip.isBesideLanes() && !hasGround) || isOutsideOfTube) vertex.present = 0;
            if (_cover.canCoverMarks() && rightCovered) vertex.rightMarks = 0;
            if (_cover.canCoverMarks() && leftCovered) vertex.leftMarks = 0;
            _mesh.vertices.push_back(vertex);
        }
        first += count;
    }
}

/// Adds both triangles of a piece of which something is drawn.
void ChunkBuilder::addQuad(const std::array<std::uint32_t, 4>& corners)
{
    const auto isDrawn = [this](std::uint32_t corner) { return _mesh.vertices[corner].present > 0; };
    if (std::none_of(corners.begin(), corners.end(), isDrawn)) return;
    for (const std::size_t corner : {0, 1, 2, 2, 1, 3})
        _mesh.indices.push_back(corners[corner]);
}

/// Adds the triangles of one level, those of the ground's strips or those of the others.
void ChunkBuilder::addTriangles(std::uint32_t firstVertex, std::size_t rows, std::size_t stride,
                                bool ofGround)
{
    const auto columns = static_cast<std::uint32_t>(_shape.columns());
    const auto ahead = static_cast<std::uint32_t>(stride) * columns;
    for (std::size_t i = 0; i + stride < rows; i += stride)
    {
        auto right = firstVertex + static_cast<std::uint32_t>(i) * columns;
        for (const Strip& strip : _shape.strips())
        {
            const auto count = static_cast<std::uint32_t>(strip.columns);
            for (std::uint32_t j = right;
                 j + 1 < right + count && isGround(_mesh.vertices[right].kind) == ofGround; ++j)
                addQuad({j, j + ahead, j + 1, j + ahead + 1});
            right += count;
        }
    }
}

void ChunkBuilder::addLevels(RoadChunk& chunk, std::uint32_t firstVertex)
{
    const std::size_t rows = (_rows.size() + 1) / 2;
    double error = 0.0;
    for (std::size_t stride = 1; stride < rows; stride *= 2)
    {
        ChunkLevel level;
        level.firstIndex = static_cast<std::uint32_t>(_mesh.indices.size());
        addTriangles(firstVertex, rows, stride, false);
        level.pavedCount = static_cast<std::uint32_t>(_mesh.indices.size()) - level.firstIndex;
        addTriangles(firstVertex, rows, stride, true);
        level.indexCount = static_cast<std::uint32_t>(_mesh.indices.size()) - level.firstIndex;
        for (std::size_t row = 0; row < _rows.size(); ++row)
            error = std::max(error, gapAt(row, 2 * stride));
        level.errorM = kBetweenSamples * error + kRoundingM;
        chunk.levels.push_back(level);
    }
}

/// Whether all of the chunk lies where positions of the mesh can be counted.
bool ChunkBuilder::isWithinReach() const
{
    const auto isNear = [this](const glm::dvec3& place)
    { return glm::all(glm::lessThan(glm::abs(place - _mesh.origin), glm::dvec3(RoadMesh::kReachM))); };
    return std::all_of(_rows.begin(), _rows.end(),
                       [&](const Row& row)
                       { return std::all_of(row.places.begin(), row.places.end(), isNear); });
}

void ChunkBuilder::add(double from, double to)
{
    sample(from, to);
    if (!isWithinReach())
    {
        if (_mesh.unreached.empty() || _mesh.unreached.back() != _road) _mesh.unreached.push_back(_road);
        return;
    }
    RoadChunk chunk;
    chunk.road = _road;
    chunk.sStart = from;
    chunk.sEnd = to;
    const auto firstVertex = static_cast<std::uint32_t>(_mesh.vertices.size());
    // A chunk lies wholly on a bridge or in a tunnel, or wholly outside.
    const RoadStructure* structure = structureAt(_network.road(_road), 0.5 * (from + to));
    const bool hasGround = structure == nullptr;
    _isInTunnel = structure && structure->kind == StructureKind::tunnel;
    const std::vector<MeshVertex> strips = stripsAt(from, hasGround);
    for (std::size_t i = 0; i < _rows.size(); i += 2)
        addRow(_rows[i], from, hasGround, strips);
    chunk.firstVertex = firstVertex;
    chunk.vertexCount = static_cast<std::uint32_t>(_mesh.vertices.size()) - firstVertex;
    addLevels(chunk, firstVertex);
    glm::dvec3 least(1e300), most(-1e300);
    for (const Row& row : _rows)
        for (const glm::dvec3& place : row.places)
        {
            least = glm::min(least, place);
            most = glm::max(most, place);
        }
    chunk.centre = 0.5 * (least + most);
    chunk.radius = 0.5 * glm::distance(least, most) + chunk.levels.front().errorM;
    _mesh.chunks.push_back(std::move(chunk));
}

} // namespace osgRoads::core
