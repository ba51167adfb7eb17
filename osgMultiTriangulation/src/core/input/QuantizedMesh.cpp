// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>

#include <foundation/Earth.h>

#include <osgMultiTriangulation/core/input/TinFile.h>

namespace osgMultiTriangulation::core
{

namespace
{

constexpr double kQuantum = 32767.0;
constexpr double kEarthM = foundation::kWgs84RadiusM, kFlattening = foundation::kWgs84Flattening;
constexpr double kMetresOfDegree = kEarthM * std::numbers::pi / 180.0;

/// Reads little-endian values one after the other.
class TileBytes
{
public:
    explicit TileBytes(std::string_view bytes) : _bytes(bytes) {}

    template<class T>
    bool take(T& value)
    {
        unsigned char raw[sizeof(T)];
        if (_bytes.size() - _at < sizeof raw) return false;
        for (std::size_t i = 0; i < sizeof raw; ++i)
            raw[i] = static_cast<unsigned char>(_bytes[_at + i]);
        _at += sizeof raw;
        if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
        std::memcpy(&value, raw, sizeof raw);
        return true;
    }

    /// Whether so many values of a size are left.
    bool isRoomFor(std::size_t count, std::size_t size) const
    {
        return count <= (_bytes.size() - _at) / size;
    }

    void alignTo(std::size_t size) { _at = std::min(_bytes.size(), (_at + size - 1) / size * size); }

private:
    std::string_view _bytes;
    std::size_t _at = 0;
};

struct TileHeader
{
    double centre[3] = {};
    float lowest = 0.0f, highest = 0.0f;
    double sphere[4] = {}, horizon[3] = {};
};

/// Degrees of the tile's side, which is 180° over a power of two; nothing: the header cannot be true.
std::optional<double> sideOf(const TileHeader& header, double latitude)
{
    const double radius = header.sphere[3];
    if (!(radius > 0.1 && radius < 2.0 * kEarthM)) return std::nullopt;
    // The sphere goes through the corners of the tile, about.
    const double diagonal = std::hypot(1.0, std::cos(latitude)) * kMetresOfDegree;
    const double level = std::round(std::log2(180.0 * diagonal / (2.0 * radius)));
    return 180.0 / std::exp2(std::clamp(level, 0.0, 30.0));
}

bool takeHeader(TileBytes& bytes, TileHeader& header)
{
    bool isThere = true;
    for (double& value : header.centre)
        isThere = isThere && bytes.take(value);
    isThere = isThere && bytes.take(header.lowest) && bytes.take(header.highest);
    for (double& value : header.sphere)
        isThere = isThere && bytes.take(value);
    for (double& value : header.horizon)
        isThere = isThere && bytes.take(value);
    return isThere;
}

/// Coordinates are differences, with the sign in the lowest bit.
bool takeCoordinates(TileBytes& bytes, std::uint32_t count, std::vector<double>& values)
{
    std::int32_t value = 0;
    for (std::uint32_t i = 0; i < count; ++i)
    {
        std::uint16_t code = 0;
        if (!bytes.take(code)) return false;
        value += (code >> 1) ^ -(code & 1);
        values.push_back(value / kQuantum);
    }
    return true;
}

/// Indices count down from the highest that has not been used.
template<class Index>
bool takeTriangles(TileBytes& bytes, std::uint32_t vertices, std::vector<Triangle>& triangles)
{
    std::uint32_t count = 0, highest = 0;
    bytes.alignTo(sizeof(Index));
    if (!bytes.take(count) || !bytes.isRoomFor(count, 3 * sizeof(Index))) return false;
    for (std::uint32_t t = 0; t < count; ++t)
    {
        Triangle triangle{};
        for (std::uint32_t& corner : triangle)
        {
            Index code = 0;
            if (!bytes.take(code) || code > highest) return false;
            corner = highest - code;
            if (code == 0) ++highest;
            if (corner >= vertices) return false;
        }
        triangles.push_back(triangle);
    }
    return true;
}

} // namespace

foundation::Result<MeasuredTin> parseQuantizedMesh(std::string_view text, const std::string& name)
{
    const auto failure = [&](const char* what) {
        return foundation::Error{name, what, "give a tile of quantized-mesh 1.0, unpacked"};
    };
    TileBytes bytes(text);
    TileHeader header;
    std::uint32_t vertices = 0;
    if (!takeHeader(bytes, header) || !bytes.take(vertices)) return failure("ends within its header");
    const double across = std::hypot(header.centre[0], header.centre[1]);
    const double latitude = std::atan2(header.centre[2], across * (1.0 - kFlattening) * (1.0 - kFlattening));
    const auto side = sideOf(header, latitude);
    if (!side || !std::isfinite(latitude) || !std::isfinite(header.lowest) || !std::isfinite(header.highest))
        return failure("has a header that cannot be true");
    if (!bytes.isRoomFor(vertices, 6)) return failure("ends within its vertices");
    std::vector<double> u, v, height;
    if (!takeCoordinates(bytes, vertices, u) || !takeCoordinates(bytes, vertices, v) ||
        !takeCoordinates(bytes, vertices, height))
        return failure("ends within its vertices");
    MeasuredTin tin;
    for (std::uint32_t i = 0; i < vertices; ++i)
        tin.points.push_back({(u[i] - 0.5) * *side * kMetresOfDegree * std::cos(latitude),
                              (v[i] - 0.5) * *side * kMetresOfDegree,
                              header.lowest + height[i] * (double(header.highest) - header.lowest)});
    const bool isWhole = vertices > 65536 ? takeTriangles<std::uint32_t>(bytes, vertices, tin.triangles)
                                          : takeTriangles<std::uint16_t>(bytes, vertices, tin.triangles);
    if (!isWhole) return failure("ends within its triangles, or has one with a vertex that is not there");
    if (tin.triangles.empty()) return failure("has no triangles");
    return tin;
}

} // namespace osgMultiTriangulation::core
