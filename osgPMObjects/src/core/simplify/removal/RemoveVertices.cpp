// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include <glm/trigonometric.hpp>

#include <osgPMObjects/core/mesh/HashIndex.h>
#include <osgPMObjects/core/simplify/RemoveVertices.h>

#include "HoleFilling.h"
#include "LiveFaces.h"
#include "PartRemoval.h"
#include "VertexStar.h"

namespace osgPMObjects::core
{

namespace
{

/// The share of a star's error that its neighbours inherit. With 1, one coarse region delays all that is
/// connected to it; with 0, small errors add up unnoticed. Of 0, 0.3, 0.5, 0.7, 0.85 and 1 this has the least
/// mean error on ten models.
constexpr double kKeptDrift = 0.85;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// An entry of the queue: a position, or a group of faces (numbers follow the positions). Stale when the
/// position has another rank now.
struct QueueEntry
{
    double rank;
    std::uint32_t number;

    bool operator<(const QueueEntry& other) const // the queue returns the largest first
    {
        return std::tie(rank, number) > std::tie(other.rank, other.number);
    }
};

/// Removes repeated numbers.
void tidy(std::vector<std::uint32_t>& numbers)
{
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

class Remover
{
public:
    Remover(const Mesh& mesh, const RemovalOptions& options)
        : _options(options),
          _creaseCosine(std::cos(glm::radians(options.creaseAngleDeg))),
          _positions(static_cast<std::uint32_t>(mesh.positions.size())),
          _live(mesh),
          _parts(_live, options.isSupport),
          _filling(_live),
          _waiting(mesh.positions.size(), kNever),
          _drift(mesh.positions.size(), 0.0),
          _refusals(mesh.positions.size(), RemovalRefusal::none),
          _isLeft(mesh.positions.size())
    {
        _sequence.faceCount = mesh.faces.size();
        for (std::uint32_t p = 0; p < _positions; ++p)
            _isLeft[p] = _live.degree(p) > 0;
        _sequence.positionCount = static_cast<std::size_t>(std::count(_isLeft.begin(), _isLeft.end(), true));
    }

    RemovalSequence run()
    {
        for (std::uint32_t part = 0; _options.removeParts && part < _parts.count(); ++part)
            _queue.push({_parts.diagonal(part), _positions + part});
        for (std::size_t before = 1, now = 0; before != now;) // refused positions are tried again at the end
        {
            before = now;
            for (std::uint32_t p = 0; p < _positions; ++p)
                if (_isLeft[p]) propose(p);
            drain();
            now = _sequence.steps.size();
        }
        for (std::uint32_t p = 0; p < _positions; ++p)
            if (_isLeft[p]) ++_sequence.left[static_cast<std::size_t>(_refusals[p])];
        return std::move(_sequence);
    }

private:
    /// Re-evaluates a position. An entry with a lower rank stays in the queue: the position is re-evaluated
    /// when it comes first, and most ranks only rise.
    void propose(std::uint32_t p)
    {
        _refusals[p] = !_options.isSupport.empty() && _options.isSupport[p]
                           ? RemovalRefusal::support
                           : gatherStar(_live, p, _creaseCosine, _star);
        if (_refusals[p] == RemovalRefusal::none && rankOf(p) < _waiting[p]) wait(p);
    }

    void wait(std::uint32_t p)
    {
        _waiting[p] = rankOf(p);
        _queue.push({_waiting[p], p});
    }

    /// Returns the rank that the order gives a position; groups have ranks above zero.
    double rankOf(std::uint32_t p) const
    {
        switch (_options.order)
        {
        case RemovalOrder::flattest:
            return _star.distance + _drift[p];
        case RemovalOrder::asNumbered:
            return 0.0;
        case RemovalOrder::shuffled:
            return -static_cast<double>(stir(1, p));
        }
        return 0.0;
    }

    void drain()
    {
        while (!_queue.empty())
        {
            const QueueEntry next = _queue.top();
            _queue.pop();
            if (next.number >= _positions)
                removePart(next.number - _positions);
            else if (_isLeft[next.number] && next.rank == _waiting[next.number])
                remove(next.number);
        }
    }

    void remove(std::uint32_t p)
    {
        const double rank = std::exchange(_waiting[p], kNever);
        _refusals[p] = gatherStar(_live, p, _creaseCosine, _star);
        if (_refusals[p] == RemovalRefusal::none && rankOf(p) > rank) return wait(p);
        if (_refusals[p] == RemovalRefusal::none) _refusals[p] = _filling.fill(_star, _options.triangulation);
        if (_refusals[p] != RemovalRefusal::none) return;
        begin(p, _drift[p] + _filling.distance(), false);
        _sequence.steps.back().apex = _filling.apex();
        for (const StarFace& f : _star.faces)
            drop(f.slot);
        for (const Face& face : _filling.faces())
        {
            _live.add(face, static_cast<std::uint32_t>(_sequence.faceCount + _sequence.addedFaces.size()));
            _sequence.addedFaces.push_back(face);
        }
        _around.clear();
        for (const StarFace& f : _star.faces)
            _around.insert(_around.end(), {f.from, f.to});
        tidy(_around);
        for (const std::uint32_t neighbour : _around)
        {
            _drift[neighbour] = std::max(_drift[neighbour], kKeptDrift * _drift[p] + _filling.distance());
            propose(neighbour);
        }
    }

    void removePart(std::uint32_t part)
    {
        if (!_parts.mayGo(part)) return;
        for (const std::uint32_t p : _parts.positionsOf(part))
        {
            if (!_isLeft[p]) continue;
            begin(p, _parts.diagonal(part), true);
            _around.clear();
            _live.visit(p, [&](std::uint32_t slot, int) { _around.push_back(slot); });
            tidy(_around); // a face that uses the position twice was added twice
            for (const std::uint32_t slot : _around)
                drop(slot);
        }
    }

    void begin(std::uint32_t p, double distance, bool isOfPart)
    {
        const double error = _sequence.steps.empty() ? 0.0 : _sequence.steps.back().error;
        _sequence.steps.push_back({p, static_cast<std::uint32_t>(_sequence.removedFaces.size()),
                                   static_cast<std::uint32_t>(_sequence.addedFaces.size()), isOfPart,
                                   std::max(error, distance)});
        _isLeft[p] = false;
    }

    void drop(std::uint32_t slot)
    {
        _sequence.removedFaces.push_back(_live.number(slot));
        _live.remove(slot);
    }

    const RemovalOptions& _options;
    double _creaseCosine;
    std::uint32_t _positions;
    LiveFaces _live;
    PartRemoval _parts;
    HoleFilling _filling;
    VertexStar _star;
    std::priority_queue<QueueEntry> _queue;
    std::vector<double> _waiting;          ///< by position: its rank in the queue, or kNever
    std::vector<double> _drift;            ///< by position: error of the faces around it
    std::vector<RemovalRefusal> _refusals; ///< by position: of the latest trial
    std::vector<bool> _isLeft;             ///< by position: used and not removed
    std::vector<std::uint32_t> _around;
    RemovalSequence _sequence;
};

} // namespace

RemovalSequence removeVertices(const Mesh& mesh, const RemovalOptions& options)
{
    return Remover(mesh, options).run();
}

} // namespace osgPMObjects::core
