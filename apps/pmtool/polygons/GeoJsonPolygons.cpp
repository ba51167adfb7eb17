// SPDX-License-Identifier: Apache-2.0
// Source: The GeoJSON Format, RFC 7946 (2016), section 3.1.
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "pmtool/polygons/ReadPolygons.h"

namespace pmtool
{

namespace
{

using Json = nlohmann::json;
using foundation::Outcome;

/// A member of an object, or null.
const Json& memberOf(const Json& object, const char* key)
{
    static const Json kNull;
    const auto found = object.find(key);
    return found != object.end() ? *found : kNull;
}

class GeoJsonReader
{
public:
    explicit GeoJsonReader(std::string file) : _file(std::move(file)) {}

    /// Reads an object of any type; `at` says where it stands.
    Outcome read(const Json& object, const std::string& at, int depth = 0)
    {
        if (object.is_null()) return foundation::success(); // a feature without a geometry
        const Json& type = memberOf(object, "type");
        if (!type.is_string()) return wrong(at, "is no GeoJSON object: it has no type");
        if (depth > kDeepest) return wrong(at, "is nested too deep");
        if (type == "FeatureCollection") return readList(object, "features", at, depth);
        if (type == "GeometryCollection") return readList(object, "geometries", at, depth);
        if (type == "Feature") return read(memberOf(object, "geometry"), at, depth + 1);
        if (type == "Polygon") return readRings(memberOf(object, "coordinates"), at);
        if (type != "MultiPolygon") return foundation::success();
        const Json& polygons = memberOf(object, "coordinates");
        if (!polygons.is_array()) return wrong(at, "has no coordinates");
        for (const Json& rings : polygons)
            if (const auto done = readRings(rings, at); !done) return done;
        return foundation::success();
    }

    PolygonSet finish() { return std::move(_set); }

private:
    static constexpr int kDeepest = 32;

    foundation::Error wrong(const std::string& at, const std::string& what) const
    {
        return {_file + (at.empty() ? "" : ", " + at), what, "repair it, see RFC 7946, section 3.1"};
    }

    Outcome readList(const Json& object, const char* key, const std::string& at, int depth)
    {
        const Json& list = memberOf(object, key);
        if (!list.is_array()) return wrong(at, std::string("has no ") + key);
        for (std::size_t i = 0; i < list.size(); ++i)
        {
            const std::string inner = (at.empty() ? "" : at + '.') + key + '[' + std::to_string(i) + ']';
            if (const auto done = read(list[i], inner, depth + 1); !done) return done;
        }
        return foundation::success();
    }

    Outcome readRings(const Json& rings, const std::string& at)
    {
        if (!rings.is_array()) return wrong(at, "has no coordinates");
        Polygon polygon;
        polygon.location = at.empty() ? "polygon" : at;
        for (const Json& ring : rings)
            if (const auto done = readRing(ring, at, polygon); !done) return done;
        if (!polygon.corners.empty()) _set.polygons.push_back(std::move(polygon));
        return foundation::success();
    }

    Outcome readRing(const Json& ring, const std::string& at, Polygon& polygon)
    {
        const auto first = static_cast<std::uint32_t>(_set.positions.size());
        if (!ring.is_array()) return wrong(at, "has a ring that is no list of positions");
        for (const Json& position : ring)
        {
            glm::dvec3 corner(0.0);
            const bool isPosition = position.is_array() && position.size() >= 2;
            for (std::size_t i = 0; isPosition && i < std::min<std::size_t>(position.size(), 3); ++i)
                corner[static_cast<int>(i)] =
                    position[i].is_number() ? position[i].get<double>() : std::nan("");
            if (!isPosition || !std::isfinite(corner.x + corner.y + corner.z))
                return wrong(at, "has a position that is not two or three finite numbers");
            _set.positions.push_back(corner);
        }
        // The last position of a ring repeats the first.
        if (_set.positions.size() > first + 1 && _set.positions.back() == _set.positions[first])
            _set.positions.pop_back();
        const auto count = static_cast<std::uint32_t>(_set.positions.size()) - first;
        if (count < 3) return wrong(at, "has a ring of fewer than three corners");
        for (std::uint32_t i = 0; i < count; ++i)
            polygon.corners.push_back(first + i);
        polygon.contourSizes.push_back(count);
        return foundation::success();
    }

    std::string _file;
    PolygonSet _set;
};

} // namespace

foundation::Result<PolygonSet> parseGeoJson(std::string_view text, const std::string& file)
{
    const Json root = Json::parse(text, nullptr, false);
    if (root.is_discarded() || root.is_null())
        return foundation::Error{file, "is no JSON text", "give a GeoJSON file"};
    GeoJsonReader reader(file);
    if (const auto done = reader.read(root, ""); !done) return done.error();
    return reader.finish();
}

} // namespace pmtool
