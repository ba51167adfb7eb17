// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "Envelope.h"

namespace osgPMObjects::core
{

/// Gathers the positions whose stars change: `to` first, since it has most of the new faces.
void EnvelopeGuard::gatherRing()
{
    _ring.clear();
    for (const std::uint32_t middle : {_from, _to})
        _stars.visitStar(middle,
                         [&](std::uint32_t face, int)
                         {
                             for (const std::uint32_t p : _stars.positions(face))
                                 if (p != _from && p != _to) _ring.push_back(p);
                         });
    std::sort(_ring.begin(), _ring.end());
    _ring.erase(std::unique(_ring.begin(), _ring.end()), _ring.end());
    _ring.insert(_ring.begin(), _to);
}

/// Returns a star after the collapse; that of `to` includes the remaining faces of `from`.
void EnvelopeGuard::starAfter(std::uint32_t position, std::vector<Corners>& faces) const
{
    faces.clear();
    const auto add = [&](std::uint32_t face, int)
    {
        const Triangle& p = _stars.positions(face);
        if (std::count_if(p.begin(), p.end(), [&](std::uint32_t c) { return c == _from || c == _to; }) > 1)
            return;
        Corners corners;
        for (int c = 0; c < 3; ++c)
            corners[c] = p[c] == _from || p[c] == _to ? _at : _positions[p[c]];
        faces.push_back(corners);
    };
    _stars.visitStar(position, add);
    if (position == _to) _stars.visitStar(_from, add);
}

bool EnvelopeGuard::newFacesHold()
{
    return std::all_of(_ringStars.front().begin(), _ringStars.front().end(),
                       [&](const Corners& face) { return _envelope.holds(face); });
}

/// Finds a star that covers an original triangle after the collapse; tries its present home first.
bool EnvelopeGuard::findsHome(std::uint32_t triangle, std::uint32_t home)
{
    const auto at = std::find(_ring.begin(), _ring.end(), home == _from ? _to : home) - _ring.begin();
    const auto covers = [&](std::size_t i) { return _envelope.isCovered(triangle, _ringStars[i]); };
    auto found = static_cast<std::size_t>(at);
    if (!covers(found))
    {
        found = 0;
        while (found < _ring.size() && !covers(found))
            ++found;
    }
    if (found == _ring.size()) return false;
    if (_ring[found] != home) _moves.push_back({triangle, home, _ring[found]});
    return true;
}

bool EnvelopeGuard::allows(std::uint32_t from, std::uint32_t to, const glm::dvec3& at)
{
    _from = from;
    _to = to;
    _at = at;
    _moves.clear();
    gatherRing();
    if (_ringStars.size() < _ring.size()) _ringStars.resize(_ring.size());
    for (std::size_t i = 0; i < _ring.size(); ++i)
        starAfter(_ring[i], _ringStars[i]);
    if (!newFacesHold()) return false;
    bool areCovered = true;
    const auto look = [&](std::uint32_t home)
    {
        _envelope.visitHomeOf(home, [&](std::uint32_t triangle)
                              { areCovered = areCovered && findsHome(triangle, home); });
    };
    look(_from);
    for (const std::uint32_t home : _ring)
        look(home);
    return areCovered;
}

void EnvelopeGuard::commit()
{
    for (const Move& move : _moves)
        _envelope.move(move.triangle, move.from, move.to);
}

} // namespace osgPMObjects::core
