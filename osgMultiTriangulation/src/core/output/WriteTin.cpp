// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <charconv>

#include <foundation/WholeFile.h>

#include <osgMultiTriangulation/core/output/WriteTin.h>

namespace osgMultiTriangulation::core
{

namespace
{

void addNumber(std::string& text, double value)
{
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text += ' ';
    text.append(digits, end);
}

template<class Bits>
void addLowestFirst(std::string& bytes, Bits bits)
{
    for (std::size_t i = 0; i < sizeof bits; ++i)
        bytes.push_back(static_cast<char>(bits >> (8 * i)));
}

double placeX(const SurfacePoint& point, const PlanFrame& frame)
{
    return frame.originX + frame.stepX * point.x;
}

double placeY(const SurfacePoint& point, const PlanFrame& frame)
{
    return frame.originY + frame.stepY * point.y;
}

/// Says how a place in the reference follows from a coordinate.
std::string placeRule(const char* axis, double first, double step)
{
    std::string text;
    addNumber(text, first);
    text += " +";
    addNumber(text, step);
    return text.substr(1) + " " + axis;
}

} // namespace

std::vector<std::string> placeLines(const PlanFrame& frame)
{
    if (!frame.reference) return {};
    const PlanReference& at = *frame.reference;
    const double stepX = at.stepX / frame.stepX, stepY = at.stepY / frame.stepY;
    const std::string name = nameOf(at);
    std::vector<std::string> lines{
        "reference system: " + (name.empty() ? std::string("a plane in metres") : name),
        "place in it: " + placeRule("x", at.firstX - frame.originX * stepX, stepX) + ", " +
            placeRule("y", at.firstY - frame.originY * stepY, stepY)};
    if (at.system.empty()) return lines;
    std::string& text = lines.emplace_back(at.system);
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return lines;
}

std::string objOf(const SurfaceMesh& mesh, const PlanFrame& frame)
{
    std::string text;
    for (const std::string& line : placeLines(frame))
        text += "# " + line + '\n';
    for (const SurfacePoint& point : mesh.points)
    {
        text += 'v';
        for (const double value : {placeX(point, frame), placeY(point, frame), point.height})
            addNumber(text, value);
        text += '\n';
    }
    for (const Triangle& triangle : mesh.triangles)
    {
        text += 'f';
        for (const std::uint32_t corner : triangle)
            text += ' ' + std::to_string(std::uint64_t{corner} + 1);
        text += '\n';
    }
    return text;
}

std::string plyOf(const SurfaceMesh& mesh, const PlanFrame& frame)
{
    std::string bytes = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& line : placeLines(frame))
        bytes += "comment " + line + '\n';
    bytes += "element vertex " + std::to_string(mesh.points.size()) +
             "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
             std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const SurfacePoint& point : mesh.points)
        for (const double value : {placeX(point, frame), placeY(point, frame), point.height})
            addLowestFirst(bytes, std::bit_cast<std::uint64_t>(value));
    for (const Triangle& triangle : mesh.triangles)
    {
        bytes.push_back(3);
        for (const std::uint32_t corner : triangle)
            addLowestFirst(bytes, corner);
    }
    return bytes;
}

foundation::Outcome writeTin(const std::filesystem::path& file, const SurfaceMesh& mesh,
                             const PlanFrame& frame)
{
    return foundation::writeWholeFile(file,
                                      file.extension() == ".ply" ? plyOf(mesh, frame) : objOf(mesh, frame));
}

} // namespace osgMultiTriangulation::core
