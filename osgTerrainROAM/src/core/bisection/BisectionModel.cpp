// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgMultiTriangulation/core/input/TinFile.h>
#include <osgTerrainROAM/core/bisection/BisectionFile.h>
#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "../RoamEntry.h"
#include "CarrierSearch.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Result;

constexpr int kDefaultLevels = 12;
constexpr double kMostFinest = 1 << 22; ///< triangles

/// Bumps from -1 to 1 that depend on the place alone, the largest of size 1.
double bumpsAt(glm::dvec3 p)
{
    double sum = 0.0, height = 0.5;
    for (int octave = 0; octave < 5; ++octave, height *= 0.5)
    {
        sum += height * std::sin(6.3 * p.x + 1.7 * p.y + octave) * std::cos(6.1 * p.y - 2.3 * p.z) *
               std::cos(1.9 * p.x + 5.7 * p.z + 2.0 * octave);
        p = 2.03 * glm::dvec3(p.y, p.z, p.x);
    }
    return sum;
}

/// Where a point of the mesh lies: on the sphere, with the relief; without a sphere relief goes in all
/// directions.
SurfaceShape shapeOf(const BisectionFile& file)
{
    return [radius = file.radius, relief = file.relief, size = file.reliefSize](const glm::dvec3& coarse)
    {
        const double length = glm::length(coarse);
        if (radius > 0.0 && length > 0.0)
        {
            const glm::dvec3 on = coarse * (radius / length);
            return on * (1.0 + relief * bumpsAt(on / size) / radius);
        }
        if (relief == 0.0) return coarse;
        const glm::dvec3 at = coarse / size;
        return coarse +
               relief * glm::dvec3(bumpsAt({at.y, at.z, at.x}), bumpsAt({at.z, at.x, at.y}), bumpsAt(at));
    };
}

Result<CoarseMesh> readCoarseMesh(const std::filesystem::path& file)
{
    const auto tin = osgMultiTriangulation::core::readTinFile(file);
    if (!tin) return tin.error();
    std::vector<glm::dvec3> points;
    for (const auto& point : tin->points)
        points.emplace_back(point[0], point[1], point[2]);
    std::vector<std::vector<std::uint32_t>> faces;
    for (const auto& t : tin->triangles)
        faces.emplace_back(t.begin(), t.end());
    return CoarseMesh::make(std::move(points), faces, file.string());
}

/// A surface of no more finest triangles than there may be.
Result<BisectionSurface> surfaceOf(CoarseMesh mesh, int levels, const SurfaceShape& shape,
                                   const std::string& name)
{
    if (std::ldexp(mesh.sides(), levels) > kMostFinest)
        return Error{name,
                     std::to_string(mesh.sides()) + " sides with " + std::to_string(levels) +
                         " levels are too many triangles",
                     "give fewer levels: sides times 2^levels may be 2^22"};
    return BisectionSurface(std::move(mesh), levels, shape);
}

/// Squares over a raster, with its heights between the samples.
Result<BisectionSurface> surfaceOfDem(const BisectionFile& file, const std::string& name)
{
    const auto field = std::make_shared<Result<HeightField>>(importDem(file.dem));
    if (!*field) return field->error();
    const HeightField& heights = **field;
    const double least = std::min(heights.columns, heights.rows) - 1.0;
    const auto along = static_cast<std::uint32_t>(std::lround((heights.columns - 1) / least)),
               up = static_cast<std::uint32_t>(std::lround((heights.rows - 1) / least));
    const double width = (heights.columns - 1) * heights.spacingEastM / along,
                 height = (heights.rows - 1) * heights.spacingNorthM / up;
    std::vector<glm::dvec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t row = 0; row <= up; ++row)
        for (std::uint32_t column = 0; column <= along; ++column)
        {
            points.emplace_back(width * column, height * row, 0.0);
            const std::uint32_t at = row * (along + 1) + column;
            if (row < up && column < along) faces.push_back({at, at + 1, at + along + 2, at + along + 1});
        }
    int levels = file.levels;
    while (file.levels == 0 && std::exp2(0.5 * levels) < least &&
           std::ldexp(4.0 * static_cast<double>(faces.size()), levels + 1) <= kMostFinest)
        ++levels;
    auto mesh = CoarseMesh::make(std::move(points), faces, name);
    if (!mesh) return mesh.error();
    return surfaceOf(
        std::move(*mesh), levels,
        [field](const glm::dvec3& p)
        {
            const HeightField& all = **field;
            const double x = p.x / all.spacingEastM, y = p.y / all.spacingNorthM;
            const int column = static_cast<int>(x), row = static_cast<int>(y);
            const double south =
                glm::mix(double(all.heightM(column, row)), double(all.heightM(column + 1, row)), x - column);
            const double north = glm::mix(double(all.heightM(column, row + 1)),
                                          double(all.heightM(column + 1, row + 1)), x - column);
            return glm::dvec3(p.x, p.y, glm::mix(south, north, y - row));
        },
        name);
}

Result<BisectionSurface> makeSurface(const BisectionFile& file, const std::string& name)
{
    if (!file.dem.empty()) return surfaceOfDem(file, name);
    auto mesh = file.mesh.empty() ? Result<CoarseMesh>(cubeMesh()) : readCoarseMesh(file.mesh);
    if (!mesh) return mesh.error();
    return surfaceOf(std::move(*mesh), file.levels > 0 ? file.levels : kDefaultLevels, shapeOf(file), name);
}

} // namespace

Result<std::shared_ptr<const BisectionModel>> openBisection(const std::filesystem::path& path)
{
    const auto text = readEntries(path);
    if (!text) return text.error();
    const auto file = parseBisectionFile(*text, path);
    if (!file) return file.error();
    auto surface = makeSurface(*file, path.string());
    if (!surface) return surface.error();
    std::vector<BisectionPatch> patches;
    for (const std::filesystem::path& tin : file->tins)
    {
        auto patch = readPatch(*surface, tin);
        if (!patch) return patch.error();
        for (const BisectionPatch& other : patches)
            if (isWithin(patch->carrier, other.carrier) || isWithin(other.carrier, patch->carrier))
                return Error{tin.string(), "lies in the triangle of another TIN",
                             "join both, move one, or give more levels"};
        patches.push_back(std::move(*patch));
    }
    return std::make_shared<const BisectionModel>(std::move(*surface), std::move(patches));
}

} // namespace osgTerrainROAM::core
