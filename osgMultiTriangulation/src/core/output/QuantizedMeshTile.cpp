// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <foundation/Earth.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osgMultiTriangulation/core/output/QuantizedMeshTile.h>

namespace osgMultiTriangulation::core
{

namespace
{

constexpr int kMostQuantum = 32767;
constexpr double kRadiusM = foundation::kWgs84RadiusM;
constexpr double kPolarRadiusM = kRadiusM * (1.0 - foundation::kWgs84Flattening);

/// A place on the Earth: degrees east and north, metres.
using GeoPoint = glm::dvec3;

/// From the middle of the Earth, metres.
glm::dvec3 fromMiddleM(const GeoPoint& at)
{
    const double longitude = at.x * std::numbers::pi / 180.0, latitude = at.y * std::numbers::pi / 180.0;
    const double sine = std::sin(latitude), e2 = foundation::kWgs84Eccentricity2;
    const double normal = kRadiusM / std::sqrt(1.0 - e2 * sine * sine);
    const double across = (normal + at.z) * std::cos(latitude);
    return {across * std::cos(longitude), across * std::sin(longitude), (normal * (1.0 - e2) + at.z) * sine};
}

/// Where the side of a triangle meets a line of a longitude (axis 0) or latitude (1): the same from both
/// sides.
GeoPoint crossing(GeoPoint a, GeoPoint b, int axis, double border)
{
    if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) std::swap(a, b);
    GeoPoint at = a + (b - a) * ((border - a[axis]) / (b[axis] - a[axis]));
    at[axis] = border;
    return at;
}

/// Cuts away what of a convex polygon lies beyond a line; `sign`: 1 keeps what is greater, -1 what is less.
std::vector<GeoPoint> keptBeside(const std::vector<GeoPoint>& polygon, int axis, double border, double sign)
{
    std::vector<GeoPoint> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const GeoPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const bool isIn = sign * (a[axis] - border) >= 0.0, isNextIn = sign * (b[axis] - border) >= 0.0;
        if (isIn) kept.push_back(a);
        if (isIn != isNextIn) kept.push_back(crossing(a, b, axis, border));
    }
    return kept;
}

/// A vertex of a tile: parts of a side to the east and to the north, and its height.
struct TileVertex
{
    int u = 0, v = 0;
    double height = 0.0;
};

/// The triangles within a tile, their vertices in the order of use.
struct TileMesh
{
    std::vector<TileVertex> vertices;
    std::vector<Triangle> triangles;
    std::size_t closed = 0;    ///< triangles without area, by rounding
    bool isTurnedOver = false; ///< whether a triangle is, by rounding
};

class TileCutter
{
public:
    explicit TileCutter(const EarthTile& tile) : _tile(tile) {}

    void add(const std::array<GeoPoint, 3>& triangle)
    {
        std::vector<GeoPoint> polygon(triangle.begin(), triangle.end());
        for (const auto& [axis, border, sign] : {std::tuple{0, _tile.west(), 1.0},
                                                 {0, _tile.east(), -1.0},
                                                 {1, _tile.south(), 1.0},
                                                 {1, _tile.north(), -1.0}})
            polygon = keptBeside(polygon, axis, border, sign);
        for (std::size_t i = 2; i < polygon.size(); ++i)
            addWithin({polygon[0], polygon[i - 1], polygon[i]});
    }

    TileMesh take() { return std::move(_mesh); }

private:
    void addWithin(const std::array<GeoPoint, 3>& triangle)
    {
        std::array<TileVertex, 3> at;
        for (std::size_t i = 0; i < 3; ++i)
            at[i] = {quantumOf(triangle[i].x - _tile.west()), quantumOf(triangle[i].y - _tile.south()),
                     triangle[i].z};
        const auto area = std::int64_t{at[1].u - at[0].u} * (at[2].v - at[0].v) -
                          std::int64_t{at[1].v - at[0].v} * (at[2].u - at[0].u);
        _mesh.isTurnedOver = _mesh.isTurnedOver || area < 0;
        _mesh.closed += area == 0;
        if (area <= 0) return;
        Triangle& corners = _mesh.triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
        {
            const auto next = static_cast<std::uint32_t>(_mesh.vertices.size());
            const auto [found, isNew] = _numbers.try_emplace({at[i].u, at[i].v}, next);
            if (isNew) _mesh.vertices.push_back(at[i]);
            corners[i] = found->second;
        }
    }

    int quantumOf(double degrees) const
    {
        return static_cast<int>(std::lround(degrees / _tile.side() * kMostQuantum));
    }

    const EarthTile& _tile;
    std::map<std::pair<int, int>, std::uint32_t> _numbers; ///< of vertices by their place
    TileMesh _mesh;
};

class TileWriter
{
public:
    template<class T>
    void add(T value)
    {
        using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t,
                                        std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint16_t>>;
        const Bits bits = std::bit_cast<Bits>(value);
        for (std::size_t i = 0; i < sizeof bits; ++i)
            _bytes.push_back(static_cast<char>(bits >> (8 * i)));
    }
    void add(const glm::dvec3& point)
    {
        for (int axis = 0; axis < 3; ++axis)
            add(point[axis]);
    }
    void alignTo(std::size_t size) { _bytes.resize((_bytes.size() + size - 1) / size * size); }
    std::string take() { return std::move(_bytes); }

private:
    std::string _bytes;
};

/// The point above the middle of a tile from where on up the tile is hidden by the Earth, where it is, over
/// the radii of the Earth.
glm::dvec3 horizonPoint(const glm::dvec3& centreM, const std::vector<glm::dvec3>& pointsM)
{
    const glm::dvec3 radii(kRadiusM, kRadiusM, kPolarRadiusM);
    const glm::dvec3 direction = glm::normalize(centreM / radii);
    double farthest = 1.0;
    for (const glm::dvec3& pointM : pointsM)
    {
        const glm::dvec3 scaled = pointM / radii;
        const double length = std::max(1.0, glm::length(scaled));
        const glm::dvec3 towards = glm::normalize(scaled);
        const double cosA = glm::dot(towards, direction), sinA = glm::length(glm::cross(towards, direction));
        const double cosB = 1.0 / length, sinB = std::sqrt(length * length - 1.0) * cosB;
        farthest = std::max(farthest, 1.0 / (cosA * cosB - sinA * sinB));
    }
    return direction * farthest;
}

class TileFile
{
public:
    TileFile(const TileMesh& mesh, const EarthTile& tile) : _mesh(mesh), _tile(tile)
    {
        const auto [low, high] = std::ranges::minmax(mesh.vertices, {}, &TileVertex::height);
        _lowM = static_cast<float>(low.height);
        _highM = static_cast<float>(high.height);
    }

    std::string bytes()
    {
        addHeader();
        _out.add(static_cast<std::uint32_t>(_mesh.vertices.size()));
        addDifferences([](const TileVertex& vertex) { return vertex.u; });
        addDifferences([](const TileVertex& vertex) { return vertex.v; });
        addDifferences([this](const TileVertex& vertex) { return heightOf(vertex); });
        if (_mesh.vertices.size() > 65536)
            addIndices<std::uint32_t>();
        else
            addIndices<std::uint16_t>();
        return _out.take();
    }

private:
    /// The sphere takes in the corners of the tile, too: by its size readers know the level.
    void addHeader()
    {
        const glm::dvec3 centreM =
            fromMiddleM({(_tile.west() + _tile.east()) / 2.0, (_tile.south() + _tile.north()) / 2.0, 0.0});
        std::vector<glm::dvec3> pointsM;
        for (const double longitude : {_tile.west(), _tile.east()})
            for (const double latitude : {_tile.south(), _tile.north()})
                pointsM.push_back(fromMiddleM({longitude, latitude, _highM}));
        for (const TileVertex& vertex : _mesh.vertices)
            pointsM.push_back(
                fromMiddleM({_tile.west() + vertex.u * _tile.side() / kMostQuantum,
                             _tile.south() + vertex.v * _tile.side() / kMostQuantum, vertex.height}));
        double radiusM = 0.0;
        for (const glm::dvec3& pointM : pointsM)
            radiusM = std::max(radiusM, glm::distance(pointM, centreM));
        _out.add(centreM);
        _out.add(_lowM);
        _out.add(_highM);
        _out.add(centreM);
        _out.add(radiusM);
        _out.add(horizonPoint(centreM, pointsM));
    }

    int heightOf(const TileVertex& vertex) const
    {
        const double span = double{_highM} - _lowM;
        if (span <= 0.0) return 0;
        return static_cast<int>(
            std::lround(std::clamp((vertex.height - _lowM) / span, 0.0, 1.0) * kMostQuantum));
    }

    /// Differences, with the sign in the lowest bit.
    template<class Value>
    void addDifferences(const Value& value)
    {
        int before = 0;
        for (const TileVertex& vertex : _mesh.vertices)
        {
            const int difference = value(vertex) - std::exchange(before, value(vertex));
            _out.add(static_cast<std::uint16_t>(difference << 1 ^ difference >> 31));
        }
    }

    /// Indices count down from the highest that has not been used; then the vertices on each side.
    template<class Index>
    void addIndices()
    {
        _out.alignTo(sizeof(Index));
        _out.add(static_cast<std::uint32_t>(_mesh.triangles.size()));
        std::uint32_t highest = 0;
        for (const Triangle& triangle : _mesh.triangles)
            for (const std::uint32_t corner : triangle)
            {
                _out.add(static_cast<Index>(highest - corner));
                if (corner == highest) ++highest;
            }
        for (const auto& [coordinate, side] : {std::pair{&TileVertex::u, 0},
                                               {&TileVertex::v, 0},
                                               {&TileVertex::u, kMostQuantum},
                                               {&TileVertex::v, kMostQuantum}})
            addSide<Index>(coordinate, side);
    }

    template<class Index>
    void addSide(int TileVertex::*coordinate, int side)
    {
        _out.add(static_cast<std::uint32_t>(std::ranges::count(_mesh.vertices, side, coordinate)));
        for (std::size_t vertex = 0; vertex < _mesh.vertices.size(); ++vertex)
            if (_mesh.vertices[vertex].*coordinate == side) _out.add(static_cast<Index>(vertex));
    }

    const TileMesh& _mesh;
    const EarthTile& _tile;
    float _lowM = 0.0f, _highM = 0.0f;
    TileWriter _out;
};

} // namespace

double EarthTile::side() const
{
    return std::ldexp(180.0, -static_cast<int>(level));
}

foundation::Result<EarthTile> earthTileOf(const std::string& name)
{
    EarthTile tile;
    int end = 0;
    const bool isForm =
        std::sscanf(name.c_str(), "%u/%u/%u%n", &tile.level, &tile.column, &tile.row, &end) == 3 &&
        end == static_cast<int>(name.size());
    if (!isForm)
        return foundation::Error{"tile " + name, "is no name of a tile",
                                 "write LEVEL/COLUMN/ROW, as 9/535/386"};
    if (tile.level < EarthTile::kLeastLevel || tile.level > EarthTile::kMostLevel)
        return foundation::Error{"tile " + name, "has another level than 3 to 22", "choose one of them"};
    if (tile.column >> tile.level >= 2 || tile.row >> tile.level >= 1)
        return foundation::Error{"tile " + name, "is not there",
                                 "columns end before " + std::to_string(2u << tile.level) + ", rows before " +
                                     std::to_string(1u << tile.level)};
    return tile;
}

foundation::Result<std::string> quantizedMeshOf(const SurfaceMesh& mesh, const PlanFrame& frame,
                                                const EarthTile& tile, const std::string& file)
{
    if (!frame.reference || !frame.reference->system.starts_with("GEOG"))
        return foundation::Error{file, "has no reference system in degrees, which tiles of the Earth need",
                                 "build it from a raster in degrees (gdalwarp -t_srs EPSG:4326)"};
    const PlanFrame degrees = inReference(frame);
    TileCutter cutter(tile);
    for (const Triangle& triangle : mesh.triangles)
    {
        std::array<GeoPoint, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const SurfacePoint& point = mesh.points[triangle[i]];
            corners[i] = {degrees.originX + degrees.stepX * point.x,
                          degrees.originY + degrees.stepY * point.y, point.height};
        }
        cutter.add(corners);
    }
    const TileMesh cut = cutter.take();
    const std::string name =
        std::to_string(tile.level) + "/" + std::to_string(tile.column) + "/" + std::to_string(tile.row);
    if (cut.triangles.empty() && cut.closed == 0)
        return foundation::Error{file, "has no ground in tile " + name,
                                 "see its extent in terraintool info, and choose another tile"};
    if (cut.isTurnedOver || cut.triangles.empty())
        return foundation::Error{file, "has points that tile " + name + " cannot tell from each other",
                                 "choose a tile of a finer level, or a larger --error"};
    return TileFile(cut, tile).bytes();
}

} // namespace osgMultiTriangulation::core
