// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace osgMultiTriangulation::core
{

/// Where a lattice lies in a reference system: place = first + step · lattice, east and north.
/// Units: those of the system.
struct PlanReference
{
    std::string system; ///< as well-known text; empty: a plane in metres, without a relation to the Earth
    double firstX = 0.0, firstY = 0.0;
    double stepX = 1.0, stepY = 1.0; ///< above 0

    bool operator==(const PlanReference&) const = default;
};

/// Where the lattice of the plan lies: place = origin + step · lattice.
/// Units: metres, or those of the input.
struct PlanFrame
{
    double originX = 0.0, originY = 0.0;
    double stepX = 1.0, stepY = 1.0;
    std::optional<PlanReference> reference{}; ///< absent: the input has none

    bool operator==(const PlanFrame&) const = default;
};

/// The frame in units of its reference; itself where it has none.
inline PlanFrame inReference(const PlanFrame& frame)
{
    if (!frame.reference) return frame;
    const PlanReference& at = *frame.reference;
    return {at.firstX, at.firstY, at.stepX, at.stepY, at};
}

/// The name of a reference system: the first that its text has between quotation marks. Empty: none.
inline std::string nameOf(const PlanReference& reference)
{
    const std::size_t from = reference.system.find('"');
    if (from == std::string::npos) return {};
    return reference.system.substr(from + 1, reference.system.find('"', from + 1) - from - 1);
}

} // namespace osgMultiTriangulation::core
