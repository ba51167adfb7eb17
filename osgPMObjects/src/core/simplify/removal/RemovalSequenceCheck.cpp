// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <osgPMObjects/core/simplify/RemovalSequence.h>

namespace osgPMObjects::core
{

namespace
{

using Side = std::pair<std::uint32_t, std::uint32_t>;

/// The number of uses of each edge from its lower end on; uses in the other direction count negative.
using Chain = std::map<Side, int>;

void add(Chain& chain, const Side& side, int times)
{
    const bool rises = side.first < side.second;
    chain[rises ? side : Side(side.second, side.first)] += rises ? times : -times;
}

/// Replays a sequence with independent bookkeeping, face by face.
class Replay
{
public:
    Replay(const RemovalSequence& sequence, const Mesh& mesh)
        : _sequence(sequence),
          _mesh(mesh),
          _facesOf(mesh.positions.size()),
          _isAlive(mesh.faces.size() + sequence.addedFaces.size(), false)
    {
        for (std::uint32_t i = 0; i < mesh.faces.size(); ++i)
            enter(i);
        for (const auto& [side, count] : _sides)
            if (count > 1) _crowded.insert(side);
    }

    std::string defect()
    {
        if (const std::string wrong = shape(); !wrong.empty()) return wrong;
        for (std::size_t k = 0; k < _sequence.steps.size(); ++k)
            if (const std::string wrong = step(k); !wrong.empty())
                return "step " + std::to_string(k) + ": " + wrong;
        return _doomed.empty() ? "" : "at the end a part is left incomplete";
    }

private:
    std::string shape()
    {
        const auto isUsed = [](const auto& faces) { return !faces.empty(); };
        _left = static_cast<std::size_t>(std::count_if(_facesOf.begin(), _facesOf.end(), isUsed));
        if (_sequence.positionCount != _left) return "the number of positions differs";
        if (_sequence.faceCount != _mesh.faces.size()) return "the number of faces differs";
        std::size_t kept = _left - std::min(_left, _sequence.steps.size());
        for (const std::size_t count : _sequence.left)
            kept -= std::min(kept, count);
        if (kept != 0) return "the counts of refusals do not match the remaining positions";
        std::uint32_t removed = 0, added = 0;
        for (const RemovalStep& step : _sequence.steps)
        {
            if (step.firstRemoved < removed || step.firstAdded < added) return "steps overlap";
            removed = step.firstRemoved;
            added = step.firstAdded;
        }
        if (removed > _sequence.removedFaces.size() || added > _sequence.addedFaces.size())
            return "steps refer to faces that do not exist";
        for (const Face& face : _sequence.addedFaces)
            if (*std::max_element(face.wedges.begin(), face.wedges.end()) >= _mesh.wedgeCount() ||
                face.material >= _mesh.materials.size() || face.part >= _mesh.parts.size())
                return "an added face has an index out of range";
        return "";
    }

    const Face& face(std::uint32_t number) const
    {
        return number < _mesh.faces.size() ? _mesh.faces[number]
                                           : _sequence.addedFaces[number - _mesh.faces.size()];
    }

    std::array<Side, 3> sidesOf(const Face& f) const
    {
        const std::uint32_t a = _mesh.positionOf(f, 0), b = _mesh.positionOf(f, 1),
                            c = _mesh.positionOf(f, 2);
        return {{{a, b}, {b, c}, {c, a}}};
    }

    bool uses(const Face& f, std::uint32_t position) const
    {
        const std::array<Side, 3> sides = sidesOf(f);
        return std::any_of(sides.begin(), sides.end(), [&](const Side& s) { return s.first == position; });
    }

    void enter(std::uint32_t number)
    {
        _isAlive[number] = true;
        for (const Side& side : sidesOf(face(number)))
        {
            ++_sides[side];
            _facesOf[side.first].insert(number);
        }
    }

    void leave(std::uint32_t number)
    {
        _isAlive[number] = false;
        for (const Side& side : sidesOf(face(number)))
        {
            --_sides[side];
            _facesOf[side.first].erase(number);
        }
    }

    std::string step(std::size_t k)
    {
        const RemovalStep& step = _sequence.steps[k];
        if (!(step.error >= (k > 0 ? _sequence.steps[k - 1].error : 0.0))) return "the error decreases";
        if (step.position >= _mesh.positions.size()) return "no such position";
        const auto removed = _sequence.removedBy(k);
        const auto added = _sequence.addedBy(k);
        const std::set<std::uint32_t> star(removed.begin(), removed.end());
        if (star.size() != removed.size() || star != _facesOf[step.position])
            return "the removed faces are not those of the position";
        if (step.isOfPart ? !added.empty() : star.empty()) return "adds faces for a part, or removes no face";
        if (!step.isOfPart && !_doomed.empty()) return "a part is left incomplete";
        if (const std::string wrong = step.isOfPart ? doom(step.position, star) : fill(step, star, added);
            !wrong.empty())
            return wrong;
        for (const std::uint32_t number : removed)
            leave(number);
        const auto first = static_cast<std::uint32_t>(_mesh.faces.size() + step.firstAdded);
        for (std::uint32_t i = 0; i < added.size(); ++i)
            enter(first + i);
        return crowding(added);
    }

    /// Marks the faces of a part for removal: their other corners must follow before any other step.
    std::string doom(std::uint32_t position, const std::set<std::uint32_t>& star)
    {
        if (star.empty() && _doomed.count(position) == 0) return "the position has no faces";
        for (const std::uint32_t number : star)
            for (const Side& side : sidesOf(face(number)))
                _doomed.insert(side.first);
        _doomed.erase(position);
        return "";
    }

    std::string fill(const RemovalStep& step, const std::set<std::uint32_t>& star,
                     std::span<const Face> added) const
    {
        std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> corners; // wedge, material, part
        Chain border;
        for (const std::uint32_t number : star)
        {
            const Face& f = face(number);
            for (const std::uint32_t wedge : f.wedges)
                corners.insert({wedge, f.material, f.part});
            for (const Side& side : sidesOf(f))
                add(border, side, 1);
        }
        for (const Face& f : added)
        {
            for (const std::uint32_t wedge : f.wedges)
                if (corners.count({wedge, f.material, f.part}) == 0 ||
                    _mesh.wedgePositions[wedge] == step.position)
                    return "an added face has a corner that no removed face had";
            for (const Side& side : sidesOf(f))
                add(border, side, -1);
            if (step.apex != RemovalStep::kNoApex && !uses(f, step.apex))
                return "an added face does not meet the others at the apex";
        }
        if (step.apex != RemovalStep::kNoApex &&
            std::none_of(star.begin(), star.end(), [&](std::uint32_t n) { return uses(face(n), step.apex); }))
            return "no removed face has the apex";
        return isClosed(border, step.position) ? "" : "the hole is not filled";
    }

    /// Whether the star's border without that of the added faces consists of open fans, each closed by one
    /// side: from the position to the fan's first neighbour, directly to its last, and back.
    static bool isClosed(const Chain& border, std::uint32_t position)
    {
        std::map<std::uint32_t, int> open; // first neighbours 1, last ones -1
        for (const auto& [side, count] : border)
            if (side.first == position || side.second == position)
                open[side.first == position ? side.second : side.first] +=
                    side.first == position ? count : -count;
        for (const auto& [side, count] : border)
        {
            if (count == 0 || side.first == position || side.second == position) continue;
            const auto [from, to] = count > 0 ? side : Side(side.second, side.first);
            if (std::abs(count) > 1 || open[from]-- != 1 || open[to]++ != -1) return false;
        }
        return true;
    }

    std::string crowding(std::span<const Face> added) const
    {
        for (const Face& f : added)
            for (const Side& side : sidesOf(f))
                if (_sides.at(side) > 1 && _crowded.count(side) == 0)
                    return "an edge has two faces of one direction";
        return "";
    }

    const RemovalSequence& _sequence;
    const Mesh& _mesh;
    std::vector<std::set<std::uint32_t>> _facesOf; ///< by position
    std::vector<bool> _isAlive;
    std::map<Side, std::size_t> _sides;
    std::set<Side> _crowded;         ///< in the mesh
    std::set<std::uint32_t> _doomed; ///< positions of parts that are being removed
    std::size_t _left = 0;
};

} // namespace

std::string removalDefectOf(const RemovalSequence& sequence, const Mesh& mesh)
{
    return Replay(sequence, mesh).defect();
}

} // namespace osgPMObjects::core
