// SPDX-License-Identifier: Apache-2.0
#include "LiveSurface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <osgPMObjects/core/order/TriangleAdjacency.h>

namespace osgMultiTriangulation::core
{

namespace
{

int cornerOfVertex(const LiveSurface::Face& face, std::uint32_t v)
{
    return face.corners[0] == v ? 0 : face.corners[1] == v ? 1 : 2;
}

float roundedUp(double value)
{
    const auto near = static_cast<float>(value);
    return near < value ? std::nextafter(near, std::numeric_limits<float>::max()) : near;
}

} // namespace

LiveSurface::LiveSurface(const MeasuredMesh& input)
    : _points(input.mesh.points), _triangleOf(input.mesh.points.size(), kNone)
{
    const SurfaceMesh& mesh = input.mesh;
    const osgPMObjects::core::TriangleAdjacency adjacency(mesh.triangles);
    _faces.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const std::uint32_t first = input.firstHidden[t];
        _faces.push_back({mesh.triangles[t], adjacency.neighbours(t), input.errors[t], first,
                          input.firstHidden[t + 1] - first, t});
        for (const std::uint32_t v : mesh.triangles[t])
            _triangleOf[v] = t;
    }
    _removed.reserve(2 * (mesh.points.size() + input.hidden.size()));
    _removed.assign(input.hidden.begin(), input.hidden.end());
}

bool LiveSurface::gatherStar(std::uint32_t v, LiveStar& star) const
{
    std::uint32_t slot = _triangleOf[v];
    bool isClosed = true;
    for (int turns = 0;; ++turns) // clockwise to the border, or round
    {
        const std::uint32_t before = _faces[slot].across[cornerOfVertex(_faces[slot], v)];
        if (before == kNone) isClosed = false;
        if (before == kNone || before == _triangleOf[v]) break;
        if (turns == LiveStar::kMost) return false;
        slot = before;
    }
    star.triangles = 0;
    for (const std::uint32_t first = slot;;)
    {
        if (star.triangles == LiveStar::kMost) return false;
        const Face& face = _faces[slot];
        const int corner = cornerOfVertex(face, v), second = (corner + 1) % 3, third = (corner + 2) % 3;
        star.slots[star.triangles] = slot;
        star.ring[star.triangles] = face.corners[second];
        star.across[star.triangles] = face.across[second];
        ++star.triangles;
        slot = face.across[third];
        star.corners = star.triangles;
        if (slot == first) break;
        if (slot != kNone) continue;
        if (star.triangles == LiveStar::kMost) return false;
        star.ring[star.triangles] = face.corners[third];
        star.across[star.triangles] = kNone;
        ++star.corners;
        break;
    }
    if (star.corners < 3) return false;
    return isClosed ||
           twiceArea(_points[star.ring[0]], _points[v], _points[star.ring[star.corners - 1]]) == 0.0;
}

void LiveSurface::replaceStar(std::uint32_t v, const LiveStar& star,
                              std::span<const HoleTriangulation::Piece> pieces, std::uint32_t firstNumber,
                              std::span<const std::uint8_t> pieceOf)
{
    makeRoom(pieceOf.size());
    std::array<Filled, LiveStar::kMost> filled;
    std::array<std::uint32_t, LiveStar::kMost> counts{};
    for (const std::uint8_t piece : pieceOf)
        ++counts[piece];
    auto next = static_cast<std::uint32_t>(_removed.size());
    _removed.resize(next + pieceOf.size()); // room is there
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
        Filled& piece = filled[p];
        piece.corners = {&_points[star.ring[pieces[p].i]], &_points[star.ring[pieces[p].j]],
                         &_points[star.ring[pieces[p].k]]};
        piece.area = twiceArea(*piece.corners[0], *piece.corners[1], *piece.corners[2]);
        piece.first = piece.next = next;
        next += counts[p];
    }
    const std::uint8_t* piece = pieceOf.data();
    put(filled[*piece++], _points[v]);
    for (int t = 0; t < star.triangles; ++t)
    {
        for (const SurfacePoint& point : removedIn(star.slots[t]))
            put(filled[*piece++], point);
        _faces[star.slots[t]].number = kNone;
    }
    _triangleOf[v] = kNone;
    link(star, pieces);
    for (std::uint32_t p = 0; p < pieces.size(); ++p)
    {
        Face& face = _faces[star.slots[p]];
        face.number = firstNumber + p;
        face.firstPoint = filled[p].first;
        face.pointCount = counts[p];
        face.error = counts[p] == 0 ? 0.0f : roundedUp(filled[p].worst[0]);
    }
}

/// Gives the first slots of the star to the pieces, and joins them with each other and with what is around.
void LiveSurface::link(const LiveStar& star, std::span<const HoleTriangulation::Piece> pieces)
{
    std::array<std::array<std::uint32_t, LiveStar::kMost>, LiveStar::kMost>
        slotOfSide; // by both ends in the ring
    for (int i = 0; i < star.corners; ++i)
        slotOfSide[(i + 1) % star.corners][i] = star.across[i];
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
        const std::array<std::uint8_t, 3> at{pieces[p].i, pieces[p].j, pieces[p].k};
        for (int c = 0; c < 3; ++c)
            slotOfSide[at[c]][at[(c + 1) % 3]] = star.slots[p];
    }
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
        const std::array<std::uint8_t, 3> at{pieces[p].i, pieces[p].j, pieces[p].k};
        const std::uint32_t slot = star.slots[p];
        Face& face = _faces[slot];
        for (int c = 0; c < 3; ++c)
        {
            const std::uint32_t from = at[c], to = at[(c + 1) % 3];
            face.corners[c] = star.ring[from];
            face.across[c] = slotOfSide[to][from];
            _triangleOf[star.ring[from]] = slot;
            if (to != (from + 1) % star.corners || face.across[c] == kNone) continue;
            Face& outside = _faces[face.across[c]]; // its side runs from `to` to `from`
            outside.across[cornerOfVertex(outside, star.ring[to])] = slot;
        }
    }
}

/// Puts the points of all faces together when there is no room for some more.
void LiveSurface::makeRoom(std::size_t count)
{
    if (_removed.size() + count <= _removed.capacity()) return;
    std::vector<SurfacePoint> together;
    together.reserve(_removed.capacity());
    for (std::uint32_t slot = 0; slot < _faces.size(); ++slot)
    {
        if (_faces[slot].number == kNone) continue;
        const std::span<const SurfacePoint> own = removedIn(slot);
        _faces[slot].firstPoint = static_cast<std::uint32_t>(together.size());
        together.insert(together.end(), own.begin(), own.end());
    }
    _removed = std::move(together);
}

/// Puts a point into a piece: among those in front when it is one of the worst, else behind them.
void LiveSurface::put(Filled& piece, const SurfacePoint& point)
{
    const SurfacePoint &a = *piece.corners[0], &b = *piece.corners[1], &c = *piece.corners[2];
    const double onA = twiceArea(b, c, point), onB = twiceArea(c, a, point), onC = twiceArea(a, b, point);
    const double height = (a.height * onA + b.height * onB + c.height * onC) / piece.area;
    const double error = std::abs(height - point.height);
    std::size_t place = piece.next - piece.first;
    if (place < kWorst)
        piece.worst[place] = error;
    else if (error > piece.worst[kWorst - 1])
    {
        place = kWorst - 1; // what is there goes to the end
        _removed[piece.next] = _removed[piece.first + place];
        piece.worst[place] = error;
    }
    ++piece.next;
    for (; place > 0 && place < kWorst && error > piece.worst[place - 1]; --place)
    {
        piece.worst[place] = piece.worst[place - 1];
        _removed[piece.first + place] = _removed[piece.first + place - 1];
        piece.worst[place - 1] = error;
    }
    _removed[piece.first + place] = point;
}

} // namespace osgMultiTriangulation::core
