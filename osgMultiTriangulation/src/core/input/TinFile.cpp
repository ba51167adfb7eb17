// SPDX-License-Identifier: Apache-2.0
#include <unordered_map>

#include <foundation/MappedFile.h>
#include <foundation/SmallLetters.h>
#include <foundation/WholeText.h>

#include <osgMultiTriangulation/core/input/TinFile.h>
#include <osgMultiTriangulation/core/surface/DropPoints.h>

#include "TinPlaces.h"

namespace osgMultiTriangulation::core
{

namespace
{

constexpr std::uintmax_t kMostTinBytes = std::uintmax_t{4} << 30;

std::string lowerExtensionOf(const std::filesystem::path& file)
{
    return foundation::inSmallLetters(file.extension().string());
}

/// Hands on what it gets, and lets go of the pages of the file that was read now and then.
class ForgetfulSink : public TinSink
{
public:
    ForgetfulSink(const foundation::MappedFile& file, TinSink& sink) : _file(file), _sink(sink) {}

    void add(const MeasuredPoint& point) override
    {
        _sink.add(point);
        count();
    }

    void add(const Triangle& triangle) override
    {
        _sink.add(triangle);
        count();
    }

private:
    void count()
    {
        if (++_taken % 4096 == 0) _file.forget();
    }

    const foundation::MappedFile& _file;
    TinSink& _sink;
    std::uint64_t _taken = 0;
};

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

foundation::Outcome streamTinFile(const std::filesystem::path& file, TinSink& sink)
{
    const auto mapped = foundation::MappedFile::open(file);
    if (!mapped) return mapped.error();
    ForgetfulSink forgetful(*mapped, sink);
    const std::string extension = lowerExtensionOf(file);
    if (extension == ".obj") return streamObj(mapped->text(), file.string(), forgetful);
    if (extension == ".ply") return streamPly(mapped->text(), file.string(), forgetful);
    const auto tin = parseQuantizedMesh(mapped->text(), file.string()); // has 65 536 points at most
    if (!tin) return tin.error();
    for (const MeasuredPoint& point : tin->points)
        sink.add(point);
    for (const Triangle& triangle : tin->triangles)
        sink.add(triangle);
    return foundation::success();
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
            return twoHeightsAt(name, p);
        numbers.push_back(found->second);
    }
    for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    {
        Triangle triangle = tin.triangles[t];
        for (std::uint32_t& corner : triangle)
            corner = numbers[corner];
        const double area = twiceArea(placed.mesh.points[triangle[0]], placed.mesh.points[triangle[1]],
                                      placed.mesh.points[triangle[2]]);
        if (area == 0.0) return noAreaAt(name, t, tin.points[tin.triangles[t][0]]);
        if (area < 0.0) std::swap(triangle[1], triangle[2]);
        placed.mesh.triangles.push_back(triangle);
    }
    dropPoints(placed.mesh, std::vector<bool>(placed.mesh.points.size(), true));
    return placed;
}

} // namespace osgMultiTriangulation::core
