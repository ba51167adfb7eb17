// SPDX-License-Identifier: Apache-2.0
// Terrains with denser parts, as they are seen: their own relief is shaded, and their borders are not seen.
#include <cmath>

#include <gtest/gtest.h>

#include <osgOffscreen/ImageComparison>

#include "RenderedPicture.h"
#include "SyntheticScene.h"

namespace
{

using namespace osgTerrainROAM;
using namespace syntheticscene;
using osgOffscreen::compareImages;

constexpr int kSide = 65, kWest = 24, kSouth = 20, kCells = 16, kExponent = 4;
constexpr double kSpacingM = 30.0;

/// A slope, and smooth hills that a sample every 30 m shows well.
double groundM(double column, double row)
{
    return 300.0 + 4.0 * column + 30.0 * std::sin(0.12 * column) * std::cos(0.1 * row);
}

/// With a part whose samples are 1.9 m apart, raised by rows of `ridgesM` metres every 15 m.
osg::ref_ptr<RoamTerrain> terrain(bool hasPart, double ridgesM)
{
    core::HeightField field;
    field.name = "slope";
    field.columns = field.rows = kSide;
    field.spacingEastM = field.spacingNorthM = kSpacingM;
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column)
            field.heightsM.push_back(static_cast<float>(groundM(column, row)));
    if (hasPart)
    {
        core::DensePart part{kWest, kSouth, kCells, kCells, kExponent, {}};
        for (int r = 0; r <= kCells << kExponent; ++r)
            for (int c = 0; c <= kCells << kExponent; ++c)
                part.heightsM.push_back(static_cast<float>(
                    groundM(kWest + std::ldexp(c, -kExponent), kSouth + std::ldexp(r, -kExponent)) +
                    ridgesM * std::sin(2.0 * M_PI * c / 8.0)));
        field.parts.push_back(std::move(part));
    }
    return dressed(
        std::make_shared<core::RoamTile>(core::PlacedTile(std::move(field), core::Placement::planar)), 0.05);
}

/// From above the eastern border of the part.
osg::ref_ptr<osg::Image> pictureOf(RoamTerrain* shown, double metres)
{
    const auto viewer = viewerOn(shown, rendered::backends().front());
    const double east = (kWest + kCells) * kSpacingM, north = (kSouth + 0.5 * kCells) * kSpacingM;
    look(*viewer, {"", {east, north - 1.0, 550.0 + metres}, {east, north, 550.0}});
    return viewer->picture();
}

/// Mean brightness of each column: what runs from south to north shows, and the grain of the ground does not.
std::vector<double> columnsOf(const osg::Image& image)
{
    std::vector<double> means;
    for (int x = 0; x < image.s(); ++x)
    {
        double sum = 0.0;
        for (int y = 0; y < image.t(); ++y)
            sum += image.data(x, y)[1];
        means.push_back(sum / image.t());
    }
    return means;
}

/// The largest difference between two columns a quarter of a ridge apart.
double contrast(const std::vector<double>& columns, std::size_t first, std::size_t end, std::size_t apart)
{
    double most = 0.0;
    for (std::size_t x = first; x + apart < end; ++x)
        most = std::max(most, std::abs(columns[x + apart] - columns[x]));
    return most;
}

TEST(JoinedTerrain, ShadesWhatOnlyItsPartsShow)
{
    const auto flat = columnsOf(*pictureOf(terrain(true, 0.0), 120.0)),
               ridged = columnsOf(*pictureOf(terrain(true, 2.0), 120.0));
    const std::size_t middle = flat.size() / 2, fading = 50, apart = 8;
    EXPECT_GT(contrast(ridged, 0, middle - fading, apart), 20.0 + contrast(flat, 0, middle - fading, apart));
    EXPECT_LT(contrast(ridged, middle + 4, flat.size(), apart),
              2.0 + contrast(flat, middle + 4, flat.size(), apart));
}

TEST(JoinedTerrain, ShowsNoBorderWhereBothSidesAgree)
{
    for (const double metres : {60.0, 400.0})
    {
        const auto with = columnsOf(*pictureOf(terrain(true, 0.0), metres)),
                   without = columnsOf(*pictureOf(terrain(false, 0.0), metres)),
                   other = columnsOf(*pictureOf(terrain(true, 1.0), metres));
        const auto largest = [&](const std::vector<double>& columns)
        {
            double most = 0.0;
            for (std::size_t x = 0; x < with.size(); ++x)
                most = std::max(most, std::abs(columns[x] - without[x]));
            return most;
        };
        EXPECT_LT(largest(with), 4.0) << metres;
        EXPECT_GT(largest(other), 4.0) << metres << ": what the part alone shows would be seen";
    }
}

} // namespace
