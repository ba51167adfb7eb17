// SPDX-License-Identifier: Apache-2.0
#include "Excerpt.h"

#include <osgPMObjects/core/mesh/HashIndex.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kNone = HashIndex::kNone;

/// Numbers the elements other than kNone in order, and lists them.
std::vector<std::uint32_t> listMarked(std::vector<std::uint32_t>& numbers)
{
    std::vector<std::uint32_t> listed;
    for (std::uint32_t i = 0; i < numbers.size(); ++i)
    {
        if (numbers[i] == kNone) continue;
        numbers[i] = static_cast<std::uint32_t>(listed.size());
        listed.push_back(i);
    }
    return listed;
}

template<class Value>
std::vector<Value> chosen(const std::vector<Value>& values, std::span<const std::uint32_t> numbers)
{
    std::vector<Value> taken;
    if (values.empty()) return taken;
    taken.reserve(numbers.size());
    for (const std::uint32_t i : numbers)
        taken.push_back(values[i]);
    return taken;
}

} // namespace

Excerpt::Excerpt(const Mesh& whole, std::span<const std::uint8_t> isWanted)
{
    takeWedges(whole, takeFaces(whole, isWanted));
    mesh.materials = whole.materials;
}

std::vector<std::uint32_t> Excerpt::takeFaces(const Mesh& whole, std::span<const std::uint8_t> isWanted)
{
    std::vector<std::uint8_t> isInnerInWhole(whole.positions.size(), 0);
    for (std::size_t f = 0; f < whole.faces.size(); ++f)
        if (isWanted[f])
            for (int i = 0; i < 3; ++i)
                isInnerInWhole[whole.positionOf(whole.faces[f], i)] = 1;
    std::vector<std::uint32_t> numbers(whole.positions.size(), kNone);
    for (std::uint32_t f = 0; f < whole.faces.size(); ++f)
    {
        const Face& face = whole.faces[f];
        const std::uint32_t a = whole.positionOf(face, 0), b = whole.positionOf(face, 1),
                            c = whole.positionOf(face, 2);
        if (!isInnerInWhole[a] && !isInnerInWhole[b] && !isInnerInWhole[c]) continue;
        numbers[a] = numbers[b] = numbers[c] = 0;
        _faces.push_back(f);
        mesh.faces.push_back(face);
    }
    _positions = listMarked(numbers);
    mesh.positions = chosen(whole.positions, _positions);
    _isInner = chosen(isInnerInWhole, _positions);
    return numbers;
}

void Excerpt::takeWedges(const Mesh& whole, std::span<const std::uint32_t> positionNumbers)
{
    std::vector<std::uint32_t> numbers(whole.wedgeCount(), kNone);
    for (const Face& face : mesh.faces)
        for (const std::uint32_t wedge : face.wedges)
            numbers[wedge] = 0;
    _wedges = listMarked(numbers);
    for (Face& face : mesh.faces)
        for (std::uint32_t& wedge : face.wedges)
            wedge = numbers[wedge];
    for (const std::uint32_t wedge : _wedges)
        mesh.wedgePositions.push_back(positionNumbers[whole.wedgePositions[wedge]]);
    mesh.normals = chosen(whole.normals, _wedges);
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
        mesh.texCoords[set] = chosen(whole.texCoords[set], _wedges);
    mesh.colours = chosen(whole.colours, _wedges);
}

void Excerpt::putBack(Mesh& whole, std::span<const std::uint32_t> origins) const
{
    for (std::size_t p = 0; p < _positions.size(); ++p)
        whole.positions[_positions[p]] = mesh.positions[p];
    std::vector<std::uint32_t> wedges = _wedges; // with the added ones
    for (std::uint32_t w = 0; w < mesh.wedgeCount(); ++w)
    {
        Wedge wedge = wedgeOf(mesh, w);
        wedge.position = _positions[wedge.position];
        if (w < _wedges.size())
            whole.wedgePositions[_wedges[w]] = wedge.position;
        else
            wedges.push_back(appendWedge(whole, wedge));
    }
    whole.materials = mesh.materials;
    std::vector<Face> faces;
    faces.reserve(whole.faces.size() + mesh.faces.size() - _faces.size());
    std::size_t next = 0, kept = 0;
    for (std::uint32_t f = 0; f < _faces.size(); ++f)
    {
        faces.insert(faces.end(), whole.faces.begin() + static_cast<std::ptrdiff_t>(kept),
                     whole.faces.begin() + static_cast<std::ptrdiff_t>(_faces[f]));
        kept = _faces[f] + 1;
        for (; next < mesh.faces.size() && origins[next] == f; ++next)
        {
            Face face = mesh.faces[next];
            for (std::uint32_t& wedge : face.wedges)
                wedge = wedges[wedge];
            faces.push_back(face);
        }
    }
    faces.insert(faces.end(), whole.faces.begin() + static_cast<std::ptrdiff_t>(kept), whole.faces.end());
    whole.faces = std::move(faces);
}

} // namespace osgPMObjects::core
