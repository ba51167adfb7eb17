// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgPMObjects/core/order/TriangleAdjacency.h>
#include <osgTerrainROAM/core/vdpm/ActiveFront.h>

namespace osgTerrainROAM::core
{

namespace
{

std::uint32_t cornerAt(const ActiveFront::Face& face, std::uint32_t vertexSlot)
{
    return face.corners[0] == vertexSlot ? 0 : face.corners[1] == vertexSlot ? 1 : 2;
}

} // namespace

ActiveFront::ActiveFront(const VertexForest& forest)
    : _forest(&forest), _slotOfVertex(forest.vertexCount(), kNone), _slotOfFace(forest.faceNumbers(), kNone)
{
    for (std::uint32_t v = 0; v < forest.rootVertices; ++v)
        addVertex(v);
    const osgPMObjects::core::TriangleAdjacency adjacency(forest.rootFaces);
    for (std::uint32_t f = 0; f < forest.rootFaces.size(); ++f)
        addFace({f, forest.rootFaces[f], adjacency.neighbours(f)}); // slots of roots are their numbers
}

bool ActiveFront::isVsplitLegal(std::uint32_t split) const
{
    const VertexSplit& s = _forest->splits[split];
    if (!isActive(s.v1) || nextSplitOf(s.v1) != split) return false;
    for (const std::uint32_t f : s.f)
        if (f != kNone && !isPresent(f)) return false;
    return true;
}

bool ActiveFront::isEcolLegal(std::uint32_t split) const
{
    const VertexSplit& s = _forest->splits[split];
    const std::uint32_t v0 = _forest->v0(split);
    if (!isActive(v0) || nextSplitOf(v0) != _forest->firstSplit[v0] ||
        nextSplitOf(s.v1) != _forest->nextSplit[split])
        return false;
    // fL runs v1, v0, vl and fR runs v0, v1, vr.
    if (s.hasLeft())
    {
        const Face& left = face(_forest->fL(split));
        if (left.across[1] != s.f[0] || left.across[2] != s.f[1]) return false;
    }
    if (!s.hasRight()) return true;
    const Face& right = face(_forest->fR(split));
    return right.across[1] == s.f[2] && right.across[2] == s.f[3];
}

void ActiveFront::vsplit(std::uint32_t split)
{
    const VertexSplit& s = _forest->splits[split];
    const std::uint32_t a = _slotOfVertex[s.v1], b = addVertex(_forest->v0(split));
    _vertices[a].nextSplit = _forest->nextSplit[split];
    replaceInFan(s, a, b);
    const std::uint32_t left = s.hasLeft() ? _forest->fL(split) : kNone,
                        right = s.hasRight() ? _forest->fR(split) : kNone;
    if (left != kNone)
    {
        const Face& beside = face(s.f[1] != kNone ? s.f[1] : s.f[0]);
        const std::uint32_t vl = s.f[1] != kNone ? beside.corners[(cornerAt(beside, a) + 1) % 3]
                                                 : beside.corners[(cornerAt(beside, b) + 2) % 3];
        linkSide(s.f[0], vl, left);
        linkSide(s.f[1], a, left);
        addFace({left, {a, b, vl}, {right, s.f[0], s.f[1]}});
    }
    if (right != kNone)
    {
        const Face& beside = face(s.f[2] != kNone ? s.f[2] : s.f[3]);
        const std::uint32_t vr = s.f[2] != kNone ? beside.corners[(cornerAt(beside, a) + 2) % 3]
                                                 : beside.corners[(cornerAt(beside, b) + 1) % 3];
        linkSide(s.f[2], vr, right);
        linkSide(s.f[3], b, right);
        addFace({right, {b, a, vr}, {left, s.f[2], s.f[3]}});
    }
}

void ActiveFront::ecol(std::uint32_t split)
{
    const VertexSplit& s = _forest->splits[split];
    const std::uint32_t a = _slotOfVertex[s.v1], v0 = _forest->v0(split), b = _slotOfVertex[v0];
    if (s.hasLeft())
    {
        const std::uint32_t left = _forest->fL(split), vl = face(left).corners[2];
        linkSide(s.f[0], vl, s.f[1]);
        linkSide(s.f[1], a, s.f[0]);
        removeFace(left);
    }
    if (s.hasRight())
    {
        const std::uint32_t right = _forest->fR(split), vr = face(right).corners[2];
        linkSide(s.f[2], vr, s.f[3]);
        linkSide(s.f[3], b, s.f[2]);
        removeFace(right);
    }
    replaceInFan(s, b, a);
    removeVertex(v0);
    _vertices[a].nextSplit = split;
}

/// Gives the faces around a vertex from f0 to f3 another vertex instead. On a border one of the two may be
/// missing: then the fan ends at the border.
void ActiveFront::replaceInFan(const VertexSplit& split, std::uint32_t from, std::uint32_t to)
{
    const bool forwards = split.f[0] != kNone;
    const std::uint32_t last = forwards ? split.f[3] : kNone;
    for (std::uint32_t number = forwards ? split.f[0] : split.f[3]; number != kNone;)
    {
        Face& f = face(number);
        const std::uint32_t corner = cornerAt(f, from);
        f.corners[corner] = to;
        _changes.triangles.push_back(_slotOfFace[number]);
        if (number == last) break;
        number = f.across[forwards ? corner : (corner + 2) % 3];
    }
}

/// Names the neighbour of a face across its side from a corner (a vertex slot).
void ActiveFront::linkSide(std::uint32_t number, std::uint32_t fromCorner, std::uint32_t to)
{
    if (number == kNone) return;
    Face& f = face(number);
    f.across[cornerAt(f, fromCorner)] = to;
}

std::uint32_t ActiveFront::firstMissing(std::uint32_t split) const
{
    const std::uint32_t parent = _forest->parent[split];
    if (parent != kNone && !isDone(parent)) return parent;
    for (const std::uint32_t f : _forest->splits[split].f)
        if (f != kNone && !isPresent(f)) return _forest->makerOfFace(f);
    return kNone;
}

void ActiveFront::forceVsplit(std::uint32_t split)
{
    // A stack instead of recursion: chains may be long.
    _forced.assign(1, split);
    while (!_forced.empty())
    {
        const std::uint32_t next = _forced.back();
        const std::uint32_t missing = isDone(next) ? kNone : firstMissing(next);
        if (missing != kNone)
        {
            _forced.push_back(missing);
            continue;
        }
        if (!isDone(next)) vsplit(next);
        _forced.pop_back();
    }
}

std::uint32_t ActiveFront::addVertex(std::uint32_t number)
{
    std::uint32_t slot = _firstFree;
    if (slot == kNone)
    {
        slot = vertexSlots();
        appendTightly(_vertices);
    }
    else
        _firstFree = _vertices[slot].nextSplit;
    _vertices[slot] = {number, _forest->firstSplit[number]};
    _slotOfVertex[number] = slot;
    ++_vertexCount;
    _changes.vertices.push_back(slot);
    return slot;
}

void ActiveFront::removeVertex(std::uint32_t number)
{
    const std::uint32_t slot = std::exchange(_slotOfVertex[number], kNone);
    _vertices[slot] = {kNone, _firstFree};
    _firstFree = slot;
    --_vertexCount;
}

void ActiveFront::addFace(const Face& face)
{
    _slotOfFace[face.number] = faceCount();
    _changes.triangles.push_back(faceCount());
    appendTightly(_faces, face);
}

void ActiveFront::removeFace(std::uint32_t number)
{
    const std::uint32_t slot = std::exchange(_slotOfFace[number], kNone);
    if (slot + 1 < faceCount())
    {
        _faces[slot] = _faces.back();
        _slotOfFace[_faces[slot].number] = slot;
        _changes.triangles.push_back(slot);
    }
    _faces.pop_back();
}

std::size_t ActiveFront::memoryBytes() const
{
    return sizeof(std::uint32_t) * (_slotOfVertex.capacity() + _slotOfFace.capacity() + _forced.capacity()) +
           _vertices.capacity() * sizeof(Vertex) + _faces.capacity() * sizeof(Face);
}

} // namespace osgTerrainROAM::core
