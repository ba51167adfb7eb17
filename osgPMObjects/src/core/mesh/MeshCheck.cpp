// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>
#include <limits>

#include <osgPMObjects/core/mesh/MeshCheck.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max() - 1;

template<class Vector>
bool isFinite(const Vector& v)
{
    for (int i = 0; i < v.length(); ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

/// Returns a defect such as "positions[7] is not finite", or an empty string.
template<class Vector>
std::string notFinite(const std::vector<Vector>& values, const char* name)
{
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!isFinite(values[i])) return std::string(name) + "[" + std::to_string(i) + "] is not finite";
    return {};
}

template<class Vector>
std::string attributeDefect(const std::vector<Vector>& values, std::size_t wedges, const char* name)
{
    if (!values.empty() && values.size() != wedges)
        return std::string(name) + " has " + std::to_string(values.size()) + " values for " +
               std::to_string(wedges) + " wedges";
    return notFinite(values, name);
}

std::string faceDefect(const Mesh& mesh)
{
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
        const Face& face = mesh.faces[f];
        const std::string place = "faces[" + std::to_string(f) + "]";
        for (const std::uint32_t wedge : face.wedges)
            if (wedge >= mesh.wedgeCount()) return place + " names wedge " + std::to_string(wedge);
        if (face.material >= mesh.materials.size())
            return place + " names material " + std::to_string(face.material);
        if (face.part >= mesh.parts.size()) return place + " names part " + std::to_string(face.part);
    }
    return {};
}

std::string wedgeDefect(const Mesh& mesh)
{
    for (std::size_t w = 0; w < mesh.wedgeCount(); ++w)
        if (mesh.wedgePositions[w] >= mesh.positions.size())
            return "wedge " + std::to_string(w) + " names position " + std::to_string(mesh.wedgePositions[w]);
    return {};
}

} // namespace

std::string defectOf(const Mesh& mesh)
{
    if (mesh.positions.size() > kMost || mesh.wedgeCount() > kMost) return "more than 2^32 - 2 vertices";
    const std::size_t wedges = mesh.wedgeCount();
    for (const std::string& defect : {notFinite(mesh.positions, "positions"), wedgeDefect(mesh),
                                      attributeDefect(mesh.normals, wedges, "normals"),
                                      attributeDefect(mesh.texCoords[0], wedges, "texCoords[0]"),
                                      attributeDefect(mesh.texCoords[1], wedges, "texCoords[1]"),
                                      attributeDefect(mesh.colours, wedges, "colours"), faceDefect(mesh)})
        if (!defect.empty()) return defect;
    return {};
}

} // namespace osgPMObjects::core
