// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/Mesh.h>

#include "PmSections.h"

namespace osgPMObjects::core
{

/// The form in which a file keeps vertices: which arrays there are (PmFlag), and the ranges of quantised
/// values.
class PmVertices
{
public:
    explicit PmVertices(const Mesh& mesh, bool isQuantised);
    explicit PmVertices(PmByteReader& head); ///< reads what writeTo() has written

    void writeTo(PmByteWriter& head) const;
    bool isSound() const;

    void writePosition(PmByteWriter& out, const glm::dvec3& position) const;
    glm::dvec3 readPosition(PmByteReader& in) const;

    /// Writes a wedge without its position.
    void writeWedge(PmByteWriter& out, const Mesh& mesh, std::uint32_t wedge) const;
    /// Appends a wedge to the arrays of the mesh that the file has.
    void readWedge(PmByteReader& in, Mesh& mesh) const;

    /// Appends a wedge of zeros to the same arrays; readWedgeAt() reads it later.
    void appendEmptyWedge(Mesh& mesh) const;
    void readWedgeAt(PmByteReader& in, Mesh& mesh, std::uint32_t wedge) const;

    /// Returns the middle of the box.
    glm::dvec3 middle() const { return _box.low + 0.5 * (_box.high - _box.low); }

    std::size_t positionBytes() const { return isQuantised() ? 6 : 24; }
    std::size_t wedgeBytes() const;

private:
    bool has(PmFlag flag) const { return (_flags & flag) != 0; }
    bool isQuantised() const { return has(pmQuantised); }

    std::uint32_t _flags = 0;
    Extent _box;
    std::array<glm::vec2, Mesh::kTexCoordSets> _texCoordLow{}, _texCoordHigh{};
};

} // namespace osgPMObjects::core
