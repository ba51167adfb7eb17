// SPDX-License-Identifier: Apache-2.0
#include "LiveFaces.h"

namespace osgPMObjects::core
{

LiveFaces::LiveFaces(const Mesh& mesh)
    : _mesh(mesh),
      _first(mesh.positions.size(), kNone),
      _degree(mesh.positions.size(), 0),
      _ofMaterial(mesh.materials.size(), 0)
{
    _slots.reserve(mesh.faces.size());
    for (std::uint32_t i = 0; i < mesh.faces.size(); ++i)
        add(mesh.faces[i], i);
}

void LiveFaces::add(const Face& face, std::uint32_t number)
{
    if (_freeSlots.empty())
    {
        _freeSlots.push_back(static_cast<std::uint32_t>(_slots.size()));
        _slots.emplace_back();
    }
    const std::uint32_t slot = _freeSlots.back();
    _freeSlots.pop_back();
    ++_ofMaterial[face.material];
    _slots[slot].face = face;
    _slots[slot].number = number;
    for (int c = 0; c < 3; ++c)
    {
        const std::uint32_t position = _mesh.positionOf(face, c);
        const HalfEdge corner = 3 * slot + static_cast<std::uint32_t>(c);
        _slots[slot].corners[c] = position;
        next(corner) = _first[position];
        previous(corner) = kNone;
        if (_first[position] != kNone) previous(_first[position]) = corner;
        _first[position] = corner;
        ++_degree[position];
    }
}

void LiveFaces::remove(std::uint32_t slot)
{
    for (int c = 0; c < 3; ++c)
    {
        const std::uint32_t position = _slots[slot].corners[c];
        const HalfEdge corner = 3 * slot + static_cast<std::uint32_t>(c);
        if (next(corner) != kNone) previous(next(corner)) = previous(corner);
        (previous(corner) != kNone ? next(previous(corner)) : _first[position]) = next(corner);
        --_degree[position];
    }
    --_ofMaterial[_slots[slot].face.material];
    _freeSlots.push_back(slot);
}

} // namespace osgPMObjects::core
