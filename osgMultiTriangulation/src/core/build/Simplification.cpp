// SPDX-License-Identifier: Apache-2.0
#include "Simplification.h"

#include <algorithm>

namespace osgMultiTriangulation::core
{

namespace
{

HoleTriangulation::Point from(const SurfacePoint& origin, const SurfacePoint& p)
{
    return {double(p.x) - origin.x, double(p.y) - origin.y, p.height - origin.height};
}

constexpr int kRounds = 3; ///< of solving a hole and measuring what was found

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
        else if (!_surface.isThere(v))
            --_left;
        else if (judge(v, candidate))
        {
            measure(candidate);
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
        if (_states[candidate.vertex] == State::judged)
        {
            gatherHole(candidate.vertex);
            fill(candidate);
        }
        else if (!judge(candidate.vertex, candidate))
        {
            _states[candidate.vertex] = State::stays;
            continue;
        }
        else if (isNext(candidate))
        {
            measure(candidate);
            _states[candidate.vertex] = State::judged;
        }
        if (isNext(candidate))
            remove(candidate);
        else
            push(candidate);
    }
}

/// Finds the best triangulation of the hole of a vertex by the worst few points of each triangle: it leaves
/// no more than the best by all points. Returns whether there is one.
bool Simplification::judge(std::uint32_t vertex, Candidate& candidate)
{
    if (!gatherHole(vertex)) return false;
    const SurfacePoint& middle = _surface.point(vertex);
    _hole.begin(std::span(_ring).first(_star.corners));
    _hole.add({0.0, 0.0, 0.0});
    for (int t = 0; t < _star.triangles; ++t)
    {
        const std::span<const SurfacePoint> removed = _surface.removedIn(_star.slots[t]);
        for (const SurfacePoint& point : removed.first(std::min(LiveSurface::kWorst, removed.size())))
            _hole.add(from(middle, point));
    }
    candidate.vertex = vertex;
    candidate.version = _versions[vertex];
    if (!solve()) return false;
    candidate.error = static_cast<float>(_hole.error());
    candidate.squares = _hole.squares();
    return true;
}

/// Gathers the star of a vertex and the corners of its hole. Returns whether the vertex may go.
bool Simplification::gatherHole(std::uint32_t vertex)
{
    if (!_surface.gatherStar(vertex, _star)) return false;
    const SurfacePoint& middle = _surface.point(vertex);
    for (int i = 0; i < _star.corners; ++i)
        _ring[i] = from(middle, _surface.point(_star.ring[i]));
    return true;
}

/// Solves the hole with the points that it has.
bool Simplification::solve()
{
    return _filling == Filling::best ? _hole.solve() : _hole.solveFan(_star.corners > _star.triangles);
}

/// Measures what judge() has found over all points. Where some are farther off than it knew, they are added,
/// and the hole is solved anew. What no point contradicts is the best by all points.
void Simplification::measure(Candidate& candidate)
{
    for (int round = 0; round < kRounds; ++round)
    {
        candidate.filling = _filling == Filling::best ? _hole.code() : _hole.codeOfFan();
        fill(candidate);
        if (_measure.greatest() <= _hole.error() || round + 1 == kRounds) break;
        for (std::size_t p = 0; p < _measure.pieces(); ++p)
            if (_measure.errorOf(p) > _hole.error()) _hole.add(_measure.worstOf(p));
        solve();
    }
    candidate.error = static_cast<float>(std::max(_measure.greatest(), _hole.error()));
    candidate.squares = _hole.squares();
}

/// Takes the triangles of a candidate, and finds in which of them each point of the hole lies.
void Simplification::fill(const Candidate& candidate)
{
    _pieces = _filling == Filling::best ? HoleTriangulation::pieces(candidate.filling, _star.corners)
                                        : HoleTriangulation::piecesOfFan(candidate.filling, _star.corners);
    _measure.begin(_pieces, std::span(_ring).first(_star.corners));
    const SurfacePoint& middle = _surface.point(candidate.vertex);
    _pieceOf.assign(1, _measure.measure({0.0, 0.0, 0.0}));
    for (int t = 0; t < _star.triangles; ++t)
        for (const SurfacePoint& point : _surface.removedIn(_star.slots[t]))
            _pieceOf.push_back(_measure.measure(from(middle, point)));
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

/// Removes the vertex whose hole was filled last.
void Simplification::remove(const Candidate& candidate)
{
    Removal removal;
    removal.vertex = candidate.vertex;
    removal.firstStar = static_cast<std::uint32_t>(_stars.size());
    if (_filling == Filling::fan) removal.apex = _star.ring[candidate.filling];
    removal.starCount = static_cast<std::uint8_t>(_star.triangles);
    removal.firstCreated = static_cast<std::uint32_t>(_corners.size());
    removal.createdCount = static_cast<std::uint8_t>(_pieces.count);
    for (int t = 0; t < _star.triangles; ++t)
        _stars.push_back(_surface.face(_star.slots[t]).number);
    _surface.replaceStar(candidate.vertex, _star, _pieces, removal.firstCreated, _pieceOf);
    for (std::size_t p = 0; p < _pieces.count; ++p)
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
        if (state == State::stays) push({0.0, _reached, _star.ring[i], _versions[_star.ring[i]], 0});
        if (state != State::locked) state = State::changed;
    }
}

} // namespace osgMultiTriangulation::core
