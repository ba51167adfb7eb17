// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <osgMultiTriangulation/core/check/ErrorCheck.h>
#include <osgMultiTriangulation/core/check/SurfaceCheck.h>
#include <osgMultiTriangulation/core/extract/Extraction.h>

namespace testsupport
{

/// The surface that extractions are compared with.
struct CheckedSurface
{
    explicit CheckedSurface(const osgMultiTriangulation::core::SurfaceMesh& mesh)
        : cells(mesh.points), outline(outlineOf(mesh))
    {
    }

    /// Tells what is wrong with an extraction, by brute force over all points: no triangulation of the
    /// surface, or a point beyond the bound of the triangle it lies in.
    std::optional<std::string> fault(const osgMultiTriangulation::core::Extraction& extraction) const
    {
        const osgMultiTriangulation::core::SurfaceMesh drawn = extraction.mesh();
        if (auto found = checkSurface(drawn, outline)) return found;
        std::vector<float> bounds;
        for (const auto& at : extraction.active())
            bounds.push_back(extraction.part(at.tree).errors[at.number]);
        if (cells.greatestExcess(drawn, bounds) > 1e-6) return "a point is beyond its bound";
        return std::nullopt;
    }

    osgMultiTriangulation::core::PointCells cells;
    std::vector<osgMultiTriangulation::core::OutlineSide> outline;
};

} // namespace testsupport
