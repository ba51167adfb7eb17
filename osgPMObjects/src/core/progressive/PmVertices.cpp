// SPDX-License-Identifier: Apache-2.0
#include "PmVertices.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace osgPMObjects::core
{

namespace
{

constexpr double kMost16 = 65535.0;

/// Quantises a value within a range to 16 bits. In a range of length zero every value becomes the low end.
std::uint16_t in16(double value, double low, double high)
{
    const double share = high > low ? (value - low) / (high - low) : 0.0;
    return static_cast<std::uint16_t>(std::lround(glm::clamp(share, 0.0, 1.0) * kMost16));
}

double from16(std::uint16_t value, double low, double high)
{
    return value == 0xffff ? high : low + (high - low) * (value / kMost16);
}

double signOf(double value)
{
    return value < 0.0 ? -1.0 : 1.0;
}

/// Encodes a direction on the octahedron |x| + |y| + |z| = 1, its lower half folded outwards; nothing for a
/// zero vector.
/// Source: Meyer et al., "On floating-point normal vectors" (2010), §3.
glm::dvec2 ontoOctahedron(const glm::dvec3& n)
{
    const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (sum == 0.0) return {0.0, 0.0};
    const glm::dvec2 p{n.x / sum, n.y / sum};
    if (n.z >= 0.0) return p;
    return {(1.0 - std::abs(p.y)) * signOf(p.x), (1.0 - std::abs(p.x)) * signOf(p.y)};
}

glm::vec3 fromOctahedron(const glm::dvec2& p)
{
    glm::dvec3 n{p.x, p.y, 1.0 - std::abs(p.x) - std::abs(p.y)};
    if (n.z < 0.0) n = {(1.0 - std::abs(p.y)) * signOf(p.x), (1.0 - std::abs(p.x)) * signOf(p.y), n.z};
    return glm::vec3(glm::normalize(n));
}

template<class Vector>
void putFloats(PmByteWriter& out, const Vector& v)
{
    for (int i = 0; i < Vector::length(); ++i)
        out.put(v[i]);
}

template<class Vector>
Vector getFloats(PmByteReader& in)
{
    Vector v{};
    for (int i = 0; i < Vector::length(); ++i)
        v[i] = in.get<typename Vector::value_type>();
    return v;
}

template<class Vector>
bool isFiniteVector(const Vector& v)
{
    bool all = true;
    for (int i = 0; i < Vector::length(); ++i)
        all = all && std::isfinite(v[i]);
    return all;
}

} // namespace

PmVertices::PmVertices(const Mesh& mesh, bool quantise) : _box(extentOf(mesh.positions))
{
    _flags = (mesh.normals.empty() ? 0u : pmNormals) | (mesh.texCoords[0].empty() ? 0u : pmTexCoords0) |
             (mesh.texCoords[1].empty() ? 0u : pmTexCoords1) | (mesh.colours.empty() ? 0u : pmColours) |
             (quantise ? pmQuantised : 0u);
    if (_box.isEmpty()) _box.add(glm::dvec3(0.0));
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
    {
        if (mesh.texCoords[set].empty()) continue;
        _texCoordLow[set] = _texCoordHigh[set] = mesh.texCoords[set].front();
        for (const glm::vec2& uv : mesh.texCoords[set])
        {
            _texCoordLow[set] = glm::min(_texCoordLow[set], uv);
            _texCoordHigh[set] = glm::max(_texCoordHigh[set], uv);
        }
    }
}

PmVertices::PmVertices(PmByteReader& head)
{
    _flags = head.get<std::uint32_t>();
    _box.low = getFloats<glm::dvec3>(head);
    _box.high = getFloats<glm::dvec3>(head);
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
    {
        _texCoordLow[set] = getFloats<glm::vec2>(head);
        _texCoordHigh[set] = getFloats<glm::vec2>(head);
    }
}

void PmVertices::writeTo(PmByteWriter& head) const
{
    head.put(_flags);
    putFloats(head, _box.low);
    putFloats(head, _box.high);
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
    {
        putFloats(head, _texCoordLow[set]);
        putFloats(head, _texCoordHigh[set]);
    }
}

bool PmVertices::isSound() const
{
    bool sound =
        _flags < 2 * pmQuantised && isFiniteVector(_box.low) && isFiniteVector(_box.high) && !_box.isEmpty();
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
        sound = sound && isFiniteVector(_texCoordLow[set]) && isFiniteVector(_texCoordHigh[set]);
    return sound;
}

std::size_t PmVertices::wedgeBytes() const
{
    const bool q = isQuantised();
    return (has(pmNormals) ? (q ? 4u : 12u) : 0u) + (has(pmTexCoords0) ? (q ? 4u : 8u) : 0u) +
           (has(pmTexCoords1) ? (q ? 4u : 8u) : 0u) + (has(pmColours) ? (q ? 4u : 16u) : 0u);
}

void PmVertices::writePosition(PmByteWriter& out, const glm::dvec3& position) const
{
    if (!isQuantised()) return putFloats(out, position);
    for (int axis = 0; axis < 3; ++axis)
        out.put(in16(position[axis], _box.low[axis], _box.high[axis]));
}

glm::dvec3 PmVertices::readPosition(PmByteReader& in) const
{
    if (!isQuantised()) return getFloats<glm::dvec3>(in);
    glm::dvec3 position{};
    for (int axis = 0; axis < 3; ++axis)
        position[axis] = from16(in.get<std::uint16_t>(), _box.low[axis], _box.high[axis]);
    return position;
}

void PmVertices::writeWedge(PmByteWriter& out, const Mesh& mesh, std::uint32_t wedge) const
{
    const bool q = isQuantised();
    if (has(pmNormals) && !q) putFloats(out, mesh.normals[wedge]);
    if (has(pmNormals) && q)
    {
        const glm::dvec2 p = ontoOctahedron(glm::dvec3(mesh.normals[wedge]));
        out.put(in16(p.x, -1.0, 1.0));
        out.put(in16(p.y, -1.0, 1.0));
    }
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
    {
        if (mesh.texCoords[set].empty()) continue;
        const glm::vec2& uv = mesh.texCoords[set][wedge];
        if (!q) putFloats(out, uv);
        for (int axis = 0; q && axis < 2; ++axis)
            out.put(in16(uv[axis], _texCoordLow[set][axis], _texCoordHigh[set][axis]));
    }
    if (has(pmColours) && !q) putFloats(out, mesh.colours[wedge]);
    for (int channel = 0; has(pmColours) && q && channel < 4; ++channel)
        out.put(static_cast<std::uint8_t>(
            std::lround(glm::clamp(mesh.colours[wedge][channel], 0.0f, 1.0f) * 255.0f)));
}

void PmVertices::appendEmptyWedge(Mesh& mesh) const
{
    if (has(pmNormals)) mesh.normals.emplace_back(0.0f);
    if (has(pmTexCoords0)) mesh.texCoords[0].emplace_back(0.0f);
    if (has(pmTexCoords1)) mesh.texCoords[1].emplace_back(0.0f);
    if (has(pmColours)) mesh.colours.emplace_back(0.0f);
}

void PmVertices::readWedge(PmByteReader& in, Mesh& mesh) const
{
    appendEmptyWedge(mesh);
    readWedgeAt(in, mesh, static_cast<std::uint32_t>(mesh.wedgeCount()) - 1);
}

void PmVertices::readWedgeAt(PmByteReader& in, Mesh& mesh, std::uint32_t wedge) const
{
    const bool q = isQuantised();
    if (has(pmNormals) && !q) mesh.normals[wedge] = getFloats<glm::vec3>(in);
    if (has(pmNormals) && q)
    {
        const double x = from16(in.get<std::uint16_t>(), -1.0, 1.0);
        mesh.normals[wedge] = fromOctahedron({x, from16(in.get<std::uint16_t>(), -1.0, 1.0)});
    }
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
    {
        if (!has(set == 0 ? pmTexCoords0 : pmTexCoords1)) continue;
        glm::vec2 uv{};
        if (!q) uv = getFloats<glm::vec2>(in);
        for (int axis = 0; q && axis < 2; ++axis)
            uv[axis] = static_cast<float>(
                from16(in.get<std::uint16_t>(), _texCoordLow[set][axis], _texCoordHigh[set][axis]));
        mesh.texCoords[set][wedge] = uv;
    }
    if (has(pmColours) && !q) mesh.colours[wedge] = getFloats<glm::vec4>(in);
    if (!has(pmColours) || !q) return;
    glm::vec4& colour = mesh.colours[wedge];
    for (int channel = 0; channel < 4; ++channel)
        colour[channel] = in.get<std::uint8_t>() / 255.0f;
}

} // namespace osgPMObjects::core
