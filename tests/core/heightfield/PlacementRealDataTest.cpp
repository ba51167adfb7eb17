// SPDX-License-Identifier: Apache-2.0
// Compares positions of every real DEM with GeographicLib, from coordinates that are computed here and not by
// the import.
#include <functional>
#include <random>

#include <GeographicLib/LocalCartesian.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "RealData.h"

namespace
{

using namespace osgTerrainROAM::core;

struct Place
{
    double latitudeDeg, longitudeDeg;
};
using PlaceOfSample = std::function<Place(int column, int row)>;

PlaceOfSample degrees(double southDeg, double westDeg, double stepDeg)
{
    return [=](int column, int row) { return Place{southDeg + row * stepDeg, westDeg + column * stepDeg}; };
}

/// UTM zone 12 on the ellipsoid of NAD83, which lies within PROJ's null transformation of WGS84.
Place greenriver(int column, int row)
{
    const GeographicLib::TransverseMercator utm(6378137.0, 1.0 / 298.257222101, 0.9996);
    Place place{};
    utm.Reverse(-111.0, 561000.5 + column - 500000.0, 4304000.5 + row, place.latitudeDeg, place.longitudeDeg);
    return place;
}

struct RealTile
{
    const char* name;
    PlaceOfSample place;
};

std::vector<RealTile> realTiles()
{
    constexpr double k3 = 3.0 / 3600.0;
    return {{"N44W072.hgt", degrees(44, -72, k3)},
            {"S33W071.tif", degrees(-33, -71, k3)},
            {"N46E008.tif", degrees(46, 8, k3)},
            {"N49W124.tif", degrees(49, -124, k3)},
            {"N49W123.tif", degrees(49, -123, k3)},
            {"mt_rainier_90m.tif", degrees(46, -122, k3)},
            {"mt_fuji_90m.tif", degrees(35, 138, k3)},
            {"N57E011.hgt", degrees(57, 11, k3)},
            {"S46W066.hgt.gz", degrees(-46, -66, k3 / 3.0)},
            {"N10W110.hgt.zip", degrees(10, -110, k3)},
            {"n43.dt0", degrees(43, -80, 10.0 * k3)},
            {"greenriver.tif", greenriver}};
}

/// Largest distance between positions of the tile and GeographicLib's, over some thousand samples.
double worstDistance(const PlacedTile& tile, const PlaceOfSample& place, double movedDeg = 0.0)
{
    const GeographicLib::LocalCartesian frame(
        tile.frame().origin().latitudeDeg, tile.frame().origin().longitudeDeg, tile.frame().origin().heightM);
    std::mt19937 random(1);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i)
    {
        const int column = static_cast<int>(random() % static_cast<unsigned>(tile.grid().dataColumns()));
        const int row = static_cast<int>(random() % static_cast<unsigned>(tile.grid().dataRows()));
        const Place p = place(column, row);
        glm::dvec3 direct;
        frame.Forward(p.latitudeDeg + movedDeg, p.longitudeDeg, tile.samples().heightM(column, row), direct.x,
                      direct.y, direct.z);
        worst = std::max(worst, glm::distance(direct, tile.position(column, row)));
    }
    return worst;
}

TEST(PlacementRealData, EverySampleIsWithinAMillimetreOfGeographicLib)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    DemImportOptions options;
    options.verticalDatum = VerticalDatum::ellipsoid;
    for (const RealTile& real : realTiles())
    {
        const auto field = importDem(folder / real.name, options);
        ASSERT_TRUE(field) << field.error().message();
        const PlacedTile tile(*field);
        EXPECT_LT(worstDistance(tile, real.place), 0.001) << real.name;
        EXPECT_GT(worstDistance(tile, real.place, 2e-8), 0.001) << "two millimetres more were not noticed";
    }
}

/// The EGM96 undulation, directly from PROJ.
class Geoid
{
public:
    Geoid()
    {
        const OGRCoordinateTransformationOptionsH options = OCTNewCoordinateTransformationOptions();
        OCTCoordinateTransformationOptionsSetOperation(
            options,
            "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad +step +proj=vgridshift "
            "+grids=egm96_15.gtx +multiplier=1 +step +proj=unitconvert +xy_in=rad +xy_out=deg",
            FALSE);
        _transform = OCTNewCoordinateTransformationEx(nullptr, nullptr, options);
        OCTDestroyCoordinateTransformationOptions(options);
    }
    ~Geoid() { OCTDestroyCoordinateTransformation(_transform); }
    Geoid(const Geoid&) = delete;
    Geoid& operator=(const Geoid&) = delete;

    double undulationM(Place place) const
    {
        double z = 0.0;
        EXPECT_TRUE(OCTTransform(_transform, 1, &place.longitudeDeg, &place.latitudeDeg, &z));
        return z;
    }

private:
    OGRCoordinateTransformationH _transform;
};

TEST(PlacementRealData, HeightsStandOnTheGeoidWithinACentimetreAndAHalf)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    const Geoid geoid;
    for (const RealTile& real : realTiles())
    {
        const auto field = importDem(folder / real.name);
        ASSERT_TRUE(field) << field.error().message();
        const PlacedTile tile(*field);
        std::mt19937 random(2);
        double worst = 0.0;
        for (int i = 0; i < 5000; ++i)
        {
            const int column = static_cast<int>(random() % static_cast<unsigned>(tile.grid().dataColumns()));
            const int row = static_cast<int>(random() % static_cast<unsigned>(tile.grid().dataRows()));
            const Geodetic found = tile.frame().geodeticFromLocal(tile.position(column, row));
            const double expected =
                tile.samples().heightM(column, row) + geoid.undulationM(real.place(column, row));
            worst = std::max(worst, std::abs(found.heightM - expected));
        }
        EXPECT_LT(worst, 0.015) << real.name;
        EXPECT_GT(std::abs(geoid.undulationM(real.place(0, 0))), 1.0)
            << "a place without undulation proves nothing";
    }
}

TEST(PlacementRealData, TheGroundIsUnderEverySampleAndBetweenItsCorners)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    for (const char* name : {"S33W071.tif", "greenriver.tif", "N46E008.tif"})
    {
        auto field = importDem(folder / name);
        ASSERT_TRUE(field);
        const PlacedTile tile(std::move(*field));
        std::mt19937 random(4);
        double worst = 0.0;
        for (int i = 0; i < 20000; ++i)
        {
            const int column =
                1 + static_cast<int>(random() % static_cast<unsigned>(tile.grid().dataColumns() - 2));
            const int row =
                1 + static_cast<int>(random() % static_cast<unsigned>(tile.grid().dataRows() - 2));
            const glm::dvec3 p = tile.position(column, row);
            const auto ground = groundAt(tile, p.x, p.y);
            ASSERT_TRUE(ground) << name << " " << column << " " << row;
            worst = std::max(worst, std::abs(ground->position.z - p.z));
        }
        EXPECT_LT(worst, 0.001) << name;
    }
}

} // namespace
