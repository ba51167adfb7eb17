// SPDX-License-Identifier: Apache-2.0
// The brute-force check of an active front.
#include <map>
#include <utility>

#include <osgTerrainROAM/core/vdpm/ActiveFront.h>

namespace osgTerrainROAM::core
{

/// Counts the faces that are reached from a face by turning around one of its corners. Precondition:
/// neighbours are right.
std::uint32_t ActiveFront::fanOf(const Face& first, std::uint32_t corner) const
{
    std::uint32_t count = 1;
    for (const int turn :
         {0, 2}) // across the side that begins at the corner, then across the one that ends there
        for (const Face* f = &first;;)
        {
            const int at = f->corners[0] == corner ? 0 : f->corners[1] == corner ? 1 : 2;
            const std::uint32_t next = f->across[(at + turn) % 3];
            if (next == first.number) return count;
            if (next == kNone) break;
            f = &face(next);
            ++count;
        }
    return count;
}

std::string ActiveFront::defect() const
{
    for (const auto check :
         {&ActiveFront::defectOfVertices, &ActiveFront::defectOfFaces, &ActiveFront::defectOfSplits})
        if (std::string found = (this->*check)(); !found.empty()) return found;
    return {};
}

/// Numbers and slots fit, and the split that a vertex waits for is the first of it that is not done.
std::string ActiveFront::defectOfVertices() const
{
    std::uint32_t active = 0;
    for (std::uint32_t v = 0; v < _forest->vertexCount(); ++v)
    {
        if (!isActive(v)) continue;
        ++active;
        const Vertex& vertex = _vertices[_slotOfVertex[v]];
        if (vertex.number != v) return "vertex " + std::to_string(v) + " is not in its slot";
        std::uint32_t next = _forest->firstSplit[v];
        while (next != kNone && isDone(next))
            next = _forest->nextSplit[next];
        if (vertex.nextSplit != next) return "vertex " + std::to_string(v) + " waits for another split";
    }
    if (active != _vertexCount) return "the number of vertices is wrong";
    std::uint32_t free = 0;
    for (std::uint32_t slot = _firstFree; slot != kNone && free <= vertexSlots();
         slot = _vertices[slot].nextSplit)
    {
        if (_vertices[slot].number != kNone) return "a free slot has a vertex";
        ++free;
    }
    return active + free == vertexSlots() ? "" : "slots of vertices are lost";
}

/// Corners are active and distinct, every side is there once in its direction, neighbours are those that have
/// the side in the opposite direction, and the faces of every vertex are one fan.
std::string ActiveFront::defectOfFaces() const
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sides;
    std::vector<std::uint32_t> uses(vertexSlots(), 0);
    for (std::uint32_t slot = 0; slot < faceCount(); ++slot)
    {
        const Face& f = _faces[slot];
        const std::string name = "face " + std::to_string(f.number);
        if (f.number >= _slotOfFace.size() || _slotOfFace[f.number] != slot)
            return name + " is not in its slot";
        for (int c = 0; c < 3; ++c)
        {
            const std::uint32_t from = f.corners[c], to = f.corners[(c + 1) % 3];
            if (from >= vertexSlots() || vertexAt(from) == kNone)
                return name + " has a corner that is not active";
            if (from == to) return name + " has a vertex twice";
            if (!sides.emplace(std::pair(from, to), f.number).second)
                return name + " has a side that another face has";
            ++uses[from];
        }
    }
    for (const Face& f : _faces)
        for (int c = 0; c < 3; ++c)
        {
            const auto other = sides.find({f.corners[(c + 1) % 3], f.corners[c]});
            const std::uint32_t number = other == sides.end() ? kNone : other->second;
            const std::string name = "face " + std::to_string(f.number);
            if (f.across[c] != number) return name + " has a wrong neighbour";
        }
    for (const Face& f : _faces)
        for (const std::uint32_t corner : f.corners)
        {
            const std::uint32_t count = std::exchange(uses[corner], 0);
            if (count != 0 && count != fanOf(f, corner)) return "a vertex has two fans";
        }
    std::uint32_t present = 0;
    for (const std::uint32_t slot : _slotOfFace)
        present += slot != kNone;
    return present == faceCount() ? "" : "slots of faces are lost";
}

/// A split that is done has done what it needs, and its faces are there.
std::string ActiveFront::defectOfSplits() const
{
    for (std::uint32_t w = 0; w < _forest->splitCount(); ++w)
    {
        const VertexSplit& s = _forest->splits[w];
        const bool done = isDone(w);
        const std::string name = "split " + std::to_string(w);
        if (isPresent(_forest->fL(w)) != (done && s.hasLeft())) return name + ": fL is wrong";
        if (isPresent(_forest->fR(w)) != (done && s.hasRight())) return name + ": fR is wrong";
        if (!done) continue;
        if (_forest->parent[w] != kNone && !isDone(_forest->parent[w]))
            return name + ": its parent is not done";
        for (const std::uint32_t f : s.f)
            if (f != kNone && !isPresent(f)) return name + ": a face beside it is missing";
    }
    return {};
}

} // namespace osgTerrainROAM::core
