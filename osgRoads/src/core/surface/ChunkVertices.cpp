// SPDX-License-Identifier: Apache-2.0
#include "ChunkVertices.h"

#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgRoads/core/place/TunnelTube.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

namespace
{

constexpr double kSlopeStepM = 0.02; ///< for the direction along the road
/// The edge of a bridge stands on 0.3 to 0.7 m beside its lanes; of two edges that stand one is a row away.
constexpr double kDeckGapM = 1.6;

std::array<std::int8_t, 4> packed(const glm::dvec3& normal, double wear)
{
    std::array<std::int8_t, 4> bytes{};
    for (int i = 0; i < 3; ++i)
        bytes[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(std::lround(127.0 * normal[i]));
    bytes[3] = static_cast<std::int8_t>(std::lround(127.0 * wear));
    return bytes;
}

/// Returns the unit normal of the surface at a column of a row, of which `other` lies `ahead` metres farther
/// along the road. A skirt is lit as the verge beside it: its own slope would show as a line where the ground
/// begins.
glm::dvec3 normalAt(const ChunkRow& row, const ChunkRow& other, std::size_t column, std::size_t first,
                    std::size_t count, bool isSkirt)
{
    const std::size_t verge = first == 0 ? count : first - 2; // beside a skirt, of two columns
    const std::size_t a = isSkirt ? verge : column > first ? column - 1 : column;
    const std::size_t b = isSkirt ? verge + 1 : column + 1 < first + count ? column + 1 : column;
    const glm::dvec3 normal = glm::cross((other.places[column] - row.places[column]) / (other.s - row.s),
                                         row.places[b] - row.places[a]);
    const double length = glm::length(normal);
    return length > 1e-9 ? normal / length : glm::dvec3(0.0, 0.0, 1.0);
}

} // namespace

ChunkVertices::ChunkVertices(const PlacedNetwork& network, int road, const LaneSection& section,
                             const OpenEnds& ends, const CrossSection& shape, const JunctionCover& cover,
                             const ChunkRows& rows, RoadMesh& mesh)
    : _network(network),
      _road(road),
      _section(section),
      _ends(ends),
      _shape(shape),
      _cover(cover),
      _rows(rows),
      _cut(cover, rows),
      _mesh(mesh)
{
}

/// Whether a lane lies outside of the tube that the paved lanes have: there is hillside, which stays as it
/// is.
bool ChunkVertices::isOutsideOfTunnel(const Lane& lane, const ChunkRow& row) const
{
    if (lane.type != LaneType::none) return false;
    const double s = std::min(row.s, std::nextafter(_section.end, _section.s));
    const auto span = laneSpan(_network.road(_road), lane.id, s);
    const RoadSides paved = pavedSides(_network.road(_road), s);
    return span && (lane.id > 0 ? span->innerT >= paved.left : span->innerT <= paved.right);
}

bool ChunkVertices::isCovered(const ChunkRow& row, double t, JunctionCover::By by)
{
    if ((t == _askedT && by == _askedBy) || !_rows.mayBeCovered()) return _isAskedCovered;
    _askedT = t;
    _askedBy = by;
    return _isAskedCovered = _cover.covers(row.s, t, by);
}

/// Whether another road's lanes begin beside a bridge, so near that no edge stands between both: the deck,
/// which lies lower, would be seen there. `first`: column of the verge; `side`: 1 to the left.
bool ChunkVertices::isDeckGap(const ChunkRow& row, std::size_t first, int side) const
{
    if (!_rows.mayBeCovered()) return false;
    const double edgeT = row.points[side > 0 ? first : first + 1].t;
    for (const double awayM : {0.0, 0.4, 0.8, 1.2, kDeckGapM})
        if (_cover.covers(row.s, edgeT + side * awayM, JunctionCover::By::paving)) return true;
    return false;
}

/// Leaves out what of a strip other roads cover. A skirt, and a strip with both borders covered, is cut at
/// the half of the way between two vertices.
void ChunkVertices::cutByOthers(std::size_t row, const Strip& strip, StripOfRow& of) const
{
    const std::size_t last = of.first + of.count - 1;
    const bool isVerge = strip.isBesideLanes() && !of.isSkirt;
    const StripCut::Place outer =
        of.isRightCovered ? StripCut::Place{row, of.first, last} : StripCut::Place{row, last, of.first};
    if (isVerge && of.isRightCovered != of.isLeftCovered && _cut.isRaised(outer))
    {
        const StripCut::Ends ends = _cut.ofRaisedVerge(outer);
        of.right = of.isRightCovered ? ends.covered : ends.across;
        of.left = of.isRightCovered ? ends.across : ends.covered;
        return;
    }
    const auto presentAt = [&](const StripCut::Place& place, bool isCoveredAcross) -> std::uint8_t
    {
        if (isVerge) return _cut.ofVerge(place, isCoveredAcross);
        return of.isSkirt || isCoveredAcross ? 0 : _cut.ofLane(place);
    };
    if (of.isRightCovered) of.right = presentAt({row, of.first, last}, of.isLeftCovered);
    if (of.isLeftCovered) of.left = presentAt({row, last, of.first}, of.isRightCovered);
}

ChunkVertices::StripOfRow ChunkVertices::stripOf(std::size_t rowIndex, const Strip& strip, std::size_t first,
                                                 const ChunkPlace& place)
{
    const ChunkRow& row = _rows.rows()[rowIndex];
    StripOfRow of;
    of.first = first;
    of.count = static_cast<std::size_t>(strip.columns);
    of.isSkirt = strip.kind == SurfaceKind::skirt;
    if (strip.isBesideLanes() && (!place.hasGround || _cover.isWithinPaving(first < 4 ? -1 : 1)))
    {
        of.right = of.left = 0;
        const bool isOnBridge = !place.hasGround && !place.isInTunnel;
        if (isOnBridge && !of.isSkirt && isDeckGap(row, first, first < 4 ? -1 : 1))
            (first < 4 ? of.left : of.right) = 255;
        return of;
    }
    // Pavings of a junction lie over each other in one plane; cut from corner to corner they would have
    // holes.
    const bool isPavingOfJunction =
        strip.lane && strip.lane->type == LaneType::special && _cover.canCoverMarks();
    const bool isCutByOthers = !(strip.lane && isForCars(strip.lane->type)) && !isPavingOfJunction;
    if (isCutByOthers || _cover.canCoverMarks())
    {
        const auto by = strip.isBesideLanes() ? JunctionCover::By::paving : JunctionCover::By::carriageway;
        of.isRightCovered = isCovered(row, row.points[first].t, by);
        of.isLeftCovered = isCovered(row, row.points[first + of.count - 1].t, by);
        if (isCutByOthers) cutByOthers(rowIndex, strip, of);
    }
    if (place.isInTunnel && strip.lane && isGround(strip.kind) && isOutsideOfTunnel(*strip.lane, row))
        of.right = of.left = 0;
    return of;
}

void ChunkVertices::addStrip(const ChunkRow& row, const ChunkRow& other, const StripOfRow& strip,
                             MeshVertex vertex)
{
    const double wear = _ends.wearAt(row.s);
    const std::size_t end = strip.first + strip.count;
    if (_cover.canCoverMarks() && strip.isRightCovered) vertex.rightMarks = 0;
    if (_cover.canCoverMarks() && strip.isLeftCovered) vertex.leftMarks = 0;
    for (std::size_t column = strip.first; column < end; ++column)
    {
        const glm::dvec3 steps = glm::round((row.places[column] - _mesh.origin) / RoadMesh::kMeshStepM);
        for (int axis = 0; axis < 3; ++axis)
            vertex.position[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(steps[axis]);
        vertex.across = static_cast<float>(row.points[column].across);
        vertex.width = static_cast<float>(row.points[column].width);
        vertex.normal = packed(normalAt(row, other, column, strip.first, strip.count, strip.isSkirt), wear);
        const double share = static_cast<double>(column - strip.first) / static_cast<double>(strip.count - 1);
        vertex.present = static_cast<std::uint8_t>(std::lround(std::lerp(strip.right, strip.left, share)));
        _mesh.vertices.push_back(vertex);
    }
}

void ChunkVertices::addRow(std::size_t rowIndex, const ChunkPlace& place,
                           const std::vector<MeshVertex>& strips)
{
    const ChunkRow& row = _rows.rows()[rowIndex];
    const double ahead = row.s + kSlopeStepM < _section.end ? kSlopeStepM : -kSlopeStepM;
    const ChunkRow other = _rows.rowAt(row.s + ahead);
    _askedT = std::numeric_limits<double>::quiet_NaN();
    _isAskedCovered = false;
    std::size_t first = 0;
    for (std::size_t i = 0; i < strips.size(); ++i)
    {
        const StripOfRow strip = stripOf(rowIndex, _shape.strips()[i], first, place);
        MeshVertex vertex = strips[i];
        vertex.s = static_cast<float>(row.s - place.from);
        addStrip(row, other, strip, vertex);
        first += strip.count;
    }
}

} // namespace osgRoads::core
