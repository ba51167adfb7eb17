// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <unordered_map>

#include <foundation/WholeText.h>

#include <osgMultiTriangulation/core/input/TinFile.h>
#include <osgMultiTriangulation/core/surface/DropPoints.h>

namespace osgMultiTriangulation::core
{

namespace
{

constexpr std::uintmax_t kMostTinBytes = std::uintmax_t{4} << 30;

std::string lowerExtensionOf(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

std::string placeOf(const MeasuredPoint& p)
{
    return "(" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ")";
}

} // namespace

bool isTinFile(const std::filesystem::path& file)
{
    const std::string extension = lowerExtensionOf(file);
    return extension == ".obj" || extension == ".ply" || extension == ".terrain";
}

foundation::Result<MeasuredTin> readTinFile(const std::filesystem::path& file)
{
    const auto bytes = foundation::readWholeText(file, kMostTinBytes);
    if (!bytes) return bytes.error();
    const std::string extension = lowerExtensionOf(file);
    if (extension == ".obj") return parseObj(*bytes, file.string());
    if (extension == ".ply") return parsePly(*bytes, file.string());
    return parseQuantizedMesh(*bytes, file.string());
}

foundation::Result<PlacedTin> placeTin(const MeasuredTin& tin, const std::string& name)
{
    PlacedTin placed;
    placed.frame = latticeFor(tin.points);
    std::unordered_map<std::uint64_t, std::uint32_t> taken; // by place
    std::vector<std::uint32_t> numbers;
    for (const MeasuredPoint& p : tin.points)
    {
        const SurfacePoint point = onLattice(placed.frame, p, placed.mostMoved);
        const auto [found, isNew] =
            taken.try_emplace(std::uint64_t(std::uint32_t(point.x)) << 32 | std::uint32_t(point.y),
                              static_cast<std::uint32_t>(placed.mesh.points.size()));
        if (isNew)
            placed.mesh.points.push_back(point);
        else if (placed.mesh.points[found->second].height != point.height)
            return foundation::Error{name, "has two heights at " + placeOf(p),
                                     "leave out walls and overhangs: each place has one height"};
        numbers.push_back(found->second);
    }
    for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    {
        Triangle triangle = tin.triangles[t];
        for (std::uint32_t& corner : triangle)
            corner = numbers[corner];
        const double area = twiceArea(placed.mesh.points[triangle[0]], placed.mesh.points[triangle[1]],
                                      placed.mesh.points[triangle[2]]);
        if (area == 0.0)
            return foundation::Error{name,
                                     "triangle " + std::to_string(t) + " at " +
                                         placeOf(tin.points[tin.triangles[t][0]]) +
                                         " has no area in the plan",
                                     "leave out walls and needles"};
        if (area < 0.0) std::swap(triangle[1], triangle[2]);
        placed.mesh.triangles.push_back(triangle);
    }
    dropPoints(placed.mesh, std::vector<bool>(placed.mesh.points.size(), true));
    return placed;
}

} // namespace osgMultiTriangulation::core
