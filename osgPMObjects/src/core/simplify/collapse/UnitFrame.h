// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Extent.h>

namespace osgPMObjects::core
{

/// The frame in which collapses are chosen: the box of a mesh has diagonal 1 and its middle at the origin.
class UnitFrame
{
public:
    explicit UnitFrame(std::span<const glm::dvec3> positions)
        : _box(extentOf(positions)),
          _middle(0.5 * (_box.low + _box.high)),
          _diagonal(_box.diagonal() > 0.0 ? _box.diagonal() : 1.0)
    {
    }

    /// The length of the frame's unit, in units of the mesh.
    double diagonal() const { return _diagonal; }

    std::vector<glm::dvec3> unit(std::span<const glm::dvec3> positions) const
    {
        std::vector<glm::dvec3> units;
        units.reserve(positions.size());
        for (const glm::dvec3& p : positions)
            units.push_back((p - _middle) * (1.0 / _diagonal));
        return units;
    }

    /// Returns a position of the frame in the mesh's frame; rounding does not lead out of the mesh's box.
    glm::dvec3 placed(const glm::dvec3& unit) const
    {
        return glm::clamp(unit * _diagonal + _middle, _box.low, _box.high);
    }

private:
    Extent _box;
    glm::dvec3 _middle;
    double _diagonal;
};

} // namespace osgPMObjects::core
