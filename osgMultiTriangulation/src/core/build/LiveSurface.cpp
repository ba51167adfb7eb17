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

double crossOf(const LiveSurface::Vertex& a, const LiveSurface::Vertex& b, const LiveSurface::Vertex& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

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
{
    const SurfaceMesh& mesh = input.mesh;
    const osgPMObjects::core::TriangleAdjacency adjacency(mesh.triangles);
    _vertices.reserve(mesh.points.size() + input.hidden.size());
    for (const SurfacePoint& p : mesh.points)
        _vertices.push_back({double(p.x), double(p.y), p.height, kNone, kNone});
    _faces.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const std::span<const SurfacePoint> hidden = input.hiddenOf(t);
        const auto first = static_cast<std::uint32_t>(_vertices.size());
        for (std::uint32_t i = 0; i < hidden.size(); ++i)
            _vertices.push_back({double(hidden[i].x), double(hidden[i].y), hidden[i].height, kNone,
                                 i + 1 < hidden.size() ? first + i + 1 : kNone});
        _faces.push_back({mesh.triangles[t], adjacency.neighbours(t), input.errors[t],
                          hidden.empty() ? kNone : first, static_cast<std::uint32_t>(hidden.size()), t});
        for (const std::uint32_t v : mesh.triangles[t])
            _vertices[v].triangle = t;
    }
}

bool LiveSurface::gatherStar(std::uint32_t v, LiveStar& star) const
{
    std::uint32_t slot = _vertices[v].triangle;
    bool isClosed = true;
    for (int turns = 0;; ++turns) // clockwise to the border, or round
    {
        const std::uint32_t before = _faces[slot].across[cornerOfVertex(_faces[slot], v)];
        if (before == kNone) isClosed = false;
        if (before == kNone || before == _vertices[v].triangle) break;
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
           crossOf(_vertices[star.ring[0]], _vertices[v], _vertices[star.ring[star.corners - 1]]) == 0.0;
}

void LiveSurface::replaceStar(std::uint32_t v, const LiveStar& star,
                              std::span<const HoleTriangulation::Piece> pieces, std::uint32_t firstNumber)
{
    std::uint32_t points = takePoints(v, star);
    for (int t = 0; t < star.triangles; ++t)
        _faces[star.slots[t]].number = kNone;
    link(star, pieces);
    for (std::uint32_t p = 0; p < pieces.size(); ++p)
        _faces[star.slots[p]].number = firstNumber + p;
    while (points != kNone)
    {
        const std::uint32_t point = points;
        points = _vertices[point].next;
        std::size_t p = 0;
        while (p + 1 < pieces.size() && !contains(_faces[star.slots[p]], _vertices[point]))
            ++p;
        addPoint(star.slots[p], point);
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
        face.error = 0.0f;
        face.firstPoint = kNone;
        face.pointCount = 0;
        for (int c = 0; c < 3; ++c)
        {
            const std::uint32_t from = at[c], to = at[(c + 1) % 3];
            face.corners[c] = star.ring[from];
            face.across[c] = slotOfSide[to][from];
            _vertices[star.ring[from]].triangle = slot;
            if (to != (from + 1) % star.corners || face.across[c] == kNone) continue;
            Face& outside = _faces[face.across[c]]; // its side runs from `to` to `from`
            outside.across[cornerOfVertex(outside, star.ring[to])] = slot;
        }
    }
}

std::uint32_t LiveSurface::takePoints(std::uint32_t v, const LiveStar& star)
{
    std::uint32_t all = v;
    _vertices[v].triangle = _vertices[v].next = kNone;
    for (int t = 0; t < star.triangles; ++t)
        for (std::uint32_t point = _faces[star.slots[t]].firstPoint; point != kNone;)
        {
            const std::uint32_t next = _vertices[point].next;
            _vertices[point].next = all;
            all = point;
            point = next;
        }
    return all;
}

/// Puts a point into a face: in front when it is the worst there, else second.
void LiveSurface::addPoint(std::uint32_t slot, std::uint32_t point)
{
    Face& face = _faces[slot];
    Vertex& p = _vertices[point];
    const Vertex &a = _vertices[face.corners[0]], &b = _vertices[face.corners[1]],
                 &c = _vertices[face.corners[2]];
    const double onA = crossOf(b, c, p), onB = crossOf(c, a, p), onC = crossOf(a, b, p);
    const double height = (a.height * onA + b.height * onB + c.height * onC) / (onA + onB + onC);
    const float error = roundedUp(std::abs(height - p.height));
    ++face.pointCount;
    if (face.firstPoint == kNone || error >= face.error)
    {
        face.error = std::max(error, face.error);
        p.next = face.firstPoint;
        face.firstPoint = point;
        return;
    }
    p.next = _vertices[face.firstPoint].next;
    _vertices[face.firstPoint].next = point;
}

bool LiveSurface::contains(const Face& face, const Vertex& point) const
{
    const Vertex &a = _vertices[face.corners[0]], &b = _vertices[face.corners[1]],
                 &c = _vertices[face.corners[2]];
    return crossOf(a, b, point) >= 0.0 && crossOf(b, c, point) >= 0.0 && crossOf(c, a, point) >= 0.0;
}

} // namespace osgMultiTriangulation::core
