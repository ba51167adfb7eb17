// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <osgTerrainROAM/core/edit/ShapeGround.h>

#include "GroundPlacer.h"
#include "VectorSource.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kHighestWorkM = TileEditor::kHighestM;

/// A number from an attribute, or what it is without one.
double numberOf(OGRFeature& feature, const char* name, double otherwise, double least, double most)
{
    const std::string text = attributeOf(feature, name);
    if (text.empty()) return otherwise;
    const double number = CPLAtof(text.c_str());
    return std::isfinite(number) ? std::clamp(number, least, most) : otherwise;
}

/// Reads the works of one source.
class WorkReader
{
public:
    explicit WorkReader(const PlacedTile& tile) : _placer(tile) {}

    /// Returns false where a shape has no heights.
    bool take(OGRFeature& feature, OGRCoordinateTransformation* toWgs84)
    {
        const OGRGeometry* const geometry = feature.GetGeometryRef();
        if (!geometry || geometry->IsEmpty()) return true;
        if (!geometry->Is3D()) return false;
        Earthwork work;
        work.widthM = numberOf(feature, "width", work.widthM, 0.1, 1000.0);
        work.crossfall = numberOf(feature, "crossfall", 0.0, 0.0, 0.2);
        work.stripM = numberOf(feature, "strip", 0.0, 0.0, 500.0);
        work.river = static_cast<int>(numberOf(feature, "river", 0.0, 0.0, 1e9));
        work.stripFall = numberOf(feature, "strip_fall", 0.0, 0.0, 0.2);
        work.slope = numberOf(feature, "slope", work.slope, 0.02, 10.0);
        work.riseM = numberOf(feature, "rise", 0.0, 0.0, 10.0);
        add(*geometry, work, toWgs84, 0);
        return true;
    }

    std::vector<Earthwork> works;

private:
    void add(const OGRGeometry& geometry, const Earthwork& like, OGRCoordinateTransformation* toWgs84,
             int depth)
    {
        const auto type = wkbFlatten(geometry.getGeometryType());
        Earthwork work = like;
        if (type == wkbLineString)
            addPath(*geometry.toLineString(), work, toWgs84);
        else if (type == wkbPolygon)
        {
            work.isArea = true;
            for (const OGRLinearRing* ring : *geometry.toPolygon())
                addPath(*ring, work, toWgs84);
        }
        else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) && depth < 8)
            for (const OGRGeometry* part : *geometry.toGeometryCollection())
                add(*part, like, toWgs84, depth + 1);
        if (!work.paths.empty() && _placer.meetsTile(work.paths.front())) works.push_back(std::move(work));
    }

    void addPath(const OGRSimpleCurve& curve, Earthwork& work, OGRCoordinateTransformation* toWgs84)
    {
        std::vector<glm::dvec2> path;
        std::vector<double> heightsM;
        const int points = curve.getNumPoints() - (work.isArea && curve.get_IsClosed() ? 1 : 0);
        for (int i = 0; i < points; ++i)
        {
            glm::dvec2 place(curve.getX(i), curve.getY(i));
            const double heightM = curve.getZ(i);
            if (!transform(place, toWgs84) || !(std::abs(heightM) < kHighestWorkM)) return;
            path.push_back(_placer.placed(place.x, place.y));
            heightsM.push_back(heightM);
        }
        work.paths.push_back(std::move(path));
        work.heightsM.push_back(std::move(heightsM));
    }

    GroundPlacer _placer;
};

} // namespace

foundation::Result<EarthworkSet> importEarthworks(const std::filesystem::path& source, const PlacedTile& tile)
{
    WorkReader reader(tile);
    auto read = forEachFeature(
        source, tile,
        [&](OGRFeature& feature, OGRLayer& layer, OGRCoordinateTransformation* toWgs84) -> foundation::Outcome
        {
            if (reader.take(feature, toWgs84)) return foundation::success();
            return foundation::Error{placeOf(source, layer) + ": feature " + std::to_string(feature.GetFID()),
                                     "has no heights",
                                     "give its points a third coordinate, metres in the samples' datum"};
        });
    if (!read) return read.error();
    return EarthworkSet{std::move(reader.works), std::move(*read)};
}

} // namespace osgTerrainROAM::core
