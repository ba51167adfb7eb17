// SPDX-License-Identifier: Apache-2.0
#include "Simplification.h"

#include <algorithm>

namespace osgMultiTriangulation::core
{

namespace
{

constexpr std::uint32_t kWorst = 4; ///< points of each triangle that a first judgement looks at

HoleTriangulation::Point relativeTo(const LiveSurface::Vertex& origin, const LiveSurface::Vertex& v)
{
    return {v.x - origin.x, v.y - origin.y, v.height - origin.height};
}

} // namespace

bool Simplification::Candidate::operator<(const Candidate& other) const
{
    if (error != other.error) return error > other.error;
    if (squares != other.squares) return squares > other.squares;
    return vertex > other.vertex;
}

Simplification::Simplification(const MeasuredMesh& input, const std::vector<bool>& isLocked, Filling filling)
    : _filling(filling),
      _surface(input),
      _versions(input.mesh.points.size(), 0),
      _states(input.mesh.points.size(), State::stays),
      _left(input.mesh.points.size()),
      _corners(input.mesh.triangles),
      _errors(input.errors)
{
    std::vector<Candidate> candidates;
    candidates.reserve(_left);
    for (std::uint32_t v = 0; v < _states.size(); ++v)
    {
        Candidate candidate;
        if (!isLocked.empty() && isLocked[v])
            _states[v] = State::locked;
        else if (_surface.vertex(v).triangle == kNone)
            --_left;
        else if (judge(v, Points::all, candidate))
        {
            _states[v] = State::judged;
            candidates.push_back(candidate);
        }
    }
    _queue = std::priority_queue<Candidate>({}, std::move(candidates));
}

void Simplification::run(std::size_t keep)
{
    while (_left > keep && !_queue.empty())
    {
        Candidate candidate = _queue.top();
        _queue.pop();
        if (!isCurrent(candidate)) continue;
        if (_states[candidate.vertex] == State::changed)
        {
            if (!judge(candidate.vertex, Points::worst, candidate))
            {
                _states[candidate.vertex] = State::stays;
                continue;
            }
            if (!isNext(candidate))
            {
                push(candidate);
                continue;
            }
        }
        const bool wasJudged = _states[candidate.vertex] == State::judged;
        judge(candidate.vertex, Points::all, candidate);
        _states[candidate.vertex] = State::judged;
        if (wasJudged || isNext(candidate))
            remove(candidate);
        else
            push(candidate);
    }
}

/// Finds the best triangulation of the hole of a vertex. Returns whether there is one.
bool Simplification::judge(std::uint32_t vertex, Points points, Candidate& candidate)
{
    if (!_surface.gatherStar(vertex, _star)) return false;
    const LiveSurface::Vertex& middle = _surface.vertex(vertex);
    for (int i = 0; i < _star.corners; ++i)
        _hole.setCorner(i, relativeTo(middle, _surface.vertex(_star.ring[i])));
    _hole.begin(_star.corners);
    _hole.add({0.0, 0.0, 0.0});
    for (int t = 0; t < _star.triangles; ++t)
    {
        const LiveSurface::Face& face = _surface.face(_star.slots[t]);
        std::uint32_t left = points == Points::all ? face.pointCount : std::min(kWorst, face.pointCount);
        for (std::uint32_t p = face.firstPoint; left > 0; p = _surface.vertex(p).next, --left)
            _hole.add(relativeTo(middle, _surface.vertex(p)));
    }
    const bool isSolved =
        _filling == Filling::best ? _hole.solve() : _hole.solveFan(_star.corners > _star.triangles);
    if (!isSolved) return false;
    candidate.vertex = vertex;
    candidate.error = static_cast<float>(_hole.error());
    candidate.squares = _hole.squares();
    candidate.version = _versions[vertex];
    return true;
}

bool Simplification::isNext(const Candidate& candidate)
{
    while (!_queue.empty() && !isCurrent(_queue.top()))
        _queue.pop();
    return _queue.empty() || !(candidate < _queue.top());
}

void Simplification::push(const Candidate& candidate)
{
    _queue.push(candidate);
}

/// Removes the vertex that was judged last, by all points.
void Simplification::remove(const Candidate& candidate)
{
    const std::span<const HoleTriangulation::Piece> pieces =
        _filling == Filling::best ? _hole.pieces() : _hole.piecesOfFan();
    Removal removal;
    removal.vertex = candidate.vertex;
    removal.firstStar = static_cast<std::uint32_t>(_stars.size());
    if (_filling == Filling::fan) removal.apex = _star.ring[_hole.apex()];
    removal.starCount = static_cast<std::uint8_t>(_star.triangles);
    removal.firstCreated = static_cast<std::uint32_t>(_corners.size());
    removal.createdCount = static_cast<std::uint8_t>(pieces.size());
    for (int t = 0; t < _star.triangles; ++t)
        _stars.push_back(_surface.face(_star.slots[t]).number);
    _surface.replaceStar(candidate.vertex, _star, pieces, removal.firstCreated);
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
        const LiveSurface::Face& face = _surface.face(_star.slots[p]);
        _corners.push_back(face.corners);
        _errors.push_back(face.error);
    }
    _removals.push_back(removal);
    ++_versions[candidate.vertex];
    --_left;
    _reached = std::max(_reached, candidate.error);
    for (int i = 0; i < _star.corners; ++i)
    {
        State& state = _states[_star.ring[i]];
        if (state == State::stays) push({0.0, _reached, _star.ring[i], _versions[_star.ring[i]]});
        if (state != State::locked) state = State::changed;
    }
}

} // namespace osgMultiTriangulation::core
