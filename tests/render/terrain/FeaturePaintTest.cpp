// SPDX-License-Identifier: Apache-2.0
// Where what is painted lies in the picture, and whether it keeps still when the eye moves.
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include <osgOffscreen/ImageComparison>

#include "FeatureScene.h"

namespace
{

using namespace osgTerrainROAM;
using namespace featurescene;
using core::FeatureKind;

constexpr double kFlash = 25.0; ///< levels
const osg::Vec3d kZenith(0.0, 0.0, 1.0);
const osg::Vec3d kNorthward(0.0, 1.0, 0.0);

/// Middle of the brightest line within `reach` of a pixel in a row, weighted by what it is brighter than
/// asphalt.
double brightMiddlePx(const osg::Image& picture, double nearPx, int row, int reach)
{
    const int middle = static_cast<int>(nearPx);
    double least = 255.0, sum = 0.0, moment = 0.0;
    for (int x = middle - reach; x <= middle + reach; ++x)
        least = std::min(least, level(picture, x, row));
    for (int x = middle - reach; x <= middle + reach; ++x)
    {
        const double bright = std::max(level(picture, x, row) - least - 45.0, 0.0);
        sum += bright;
        moment += bright * (x + 0.5);
    }
    return sum > 0.0 ? moment / sum : -1e9;
}

/// The worst distance, in pixels, of the inner edge line from where it has to be; seen from 2 m above the
/// lane's middle.
double worstLineErrorPx(const osg::ref_ptr<RoamTerrain>& terrain, double roadEast, double halfWidthM)
{
    Camera camera(terrain);
    const osg::Vec3d eye(roadEast, 20000.0, 2.0);
    const auto picture = camera.picture(eye, osg::Vec3d(0.0, 1.0, -0.15), kZenith);
    double worst = 0.0;
    for (const double ahead : {8.0, 12.0, 16.0})
        for (const double side : {-1.0, 1.0})
        {
            const double lineEast = roadEast + side * (halfWidthM - 0.31);
            const int row = static_cast<int>(camera.pixelOf(osg::Vec3d(lineEast, 20000.0 + ahead, 0.0)).y());
            // The place at this row's own distance: rows are a third of a metre apart there.
            double distance = ahead;
            for (int i = 0; i < 40; ++i)
                distance +=
                    0.02 *
                    (camera.pixelOf(osg::Vec3d(lineEast, 20000.0 + distance, 0.0)).y() < row + 0.5 ? 1 : -1);
            const double expected = camera.pixelOf(osg::Vec3d(lineEast, 20000.0 + distance, 0.0)).x();
            worst = std::max(worst, std::abs(brightMiddlePx(*picture, expected, row, 6) - expected));
        }
    return worst;
}

/// Left and right edge of a dark strip in a row, where its share crosses a half. Pixels.
std::pair<double, double> edgesPx(const osg::Image& with, const osg::Image& without, int row)
{
    // Light is mixed, not levels: what displayColour() does is undone.
    const auto light = [&](const osg::Image& picture, int x)
    { return -std::log(1.0 - std::pow(level(picture, x, row) / 255.5, 2.0)); };
    const auto drop = [&](int x) { return light(without, x) - light(with, x); };
    double most = 0.0;
    for (int x = 0; x < kWidthPx; ++x)
        most = std::max(most, drop(x));
    double first = -1.0, last = -1.0;
    for (int x = 0; x + 1 < kWidthPx; ++x)
    {
        const double a = drop(x) / most - 0.5, b = drop(x + 1) / most - 0.5;
        if (a < 0.0 && b >= 0.0 && first < 0.0) first = x + 0.5 + a / (a - b);
        if (a >= 0.0 && b < 0.0) last = x + 0.5 + a / (a - b);
    }
    return {first, last};
}

/// The worst distance of an edge from where a strip 31 m wide has to have it; of a strip that is `widthM`
/// wide, from 500 m.
double worstStripErrorPx(double east, double widthM)
{
    // Too short for markings: a strip of asphalt. Snow around it is even, and bright.
    const auto with = plain({line(FeatureKind::runway, widthM, {east, 19920.0}, {east, 20080.0})}, true);
    Camera camera(with), bare(plain({}, true));
    const osg::Vec3d eye(east + 40.0, 20000.0, 500.0);
    const auto picture = camera.picture(eye, -kZenith, kNorthward);
    const auto ground = bare.picture(eye, -kZenith, kNorthward);
    double left = 0.0, right = 0.0;
    for (int row = 120; row < 150; ++row)
    {
        const auto [first, last] = edgesPx(*picture, *ground, row);
        left += first / 30.0;
        right += last / 30.0;
    }
    return std::max(std::abs(left - camera.pixelOf(osg::Vec3d(east - 15.5, 20000.0, 0.0)).x()),
                    std::abs(right - camera.pixelOf(osg::Vec3d(east + 15.5, 20000.0, 0.0)).x()));
}

/// Pixels that flash: brighter or darker than in the frame before and after by more than kFlash levels. Above
/// row 125, which is farther than 25 m for the driver: nearer grains of the soil are larger than pixels and
/// do pass by.
std::size_t flashes(const osg::ref_ptr<RoamTerrain>& terrain, const osg::Vec3d& from, const osg::Vec3d& step,
                    const osg::Vec3d& ahead)
{
    Camera camera(terrain);
    std::vector<osg::ref_ptr<osg::Image>> frames;
    std::size_t count = 0;
    for (int frame = 0; frame < 24; ++frame)
    {
        frames.push_back(camera.picture(from + step * frame, ahead, kZenith));
        if (frame < 2) continue;
        for (int y = 125; y < kHeightPx; ++y)
            for (int x = 0; x < kWidthPx; ++x)
            {
                const double now = level(*frames[frame - 1], x, y);
                const double before = now - level(*frames[frame - 2], x, y),
                             after = now - level(*frames[frame], x, y);
                if (before * after > 0.0 && std::min(std::abs(before), std::abs(after)) > kFlash) ++count;
            }
    }
    return count;
}

std::vector<core::GroundFeature> roadsOfAPlain()
{
    std::vector<core::GroundFeature> features;
    for (int i = 0; i < 12; ++i)
    {
        features.push_back(
            line(FeatureKind::road, 8.0, {19000.0, 20040.0 + 70.0 * i}, {21500.0, 20090.0 + 75.0 * i}));
        features.push_back(
            line(FeatureKind::road, 7.0, {19800.0 + 90.0 * i, 19900.0}, {19700.0 + 95.0 * i, 23000.0}));
    }
    return features;
}

} // namespace

TEST(FeaturePaint, ADriverSeesTheEdgeLineWhereItIs)
{
    for (const double roadEast : {1000.3, 4096.0, 60000.7})
    {
        const auto terrain = plain({line(FeatureKind::road, 8.0, {roadEast, 19000.0}, {roadEast, 23000.0})});
        const double error = worstLineErrorPx(terrain, roadEast, 4.0);
        EXPECT_LT(error, 0.35) << roadEast;
        RecordProperty("worstPx", std::to_string(error));
    }
}

TEST(FeaturePaint, ALineTenCentimetresOffIsFoundOut)
{
    const auto terrain = plain({line(FeatureKind::road, 8.2, {1000.3, 19000.0}, {1000.3, 23000.0})});
    EXPECT_GT(worstLineErrorPx(terrain, 1000.3, 4.0), 1.0);
}

TEST(FeaturePaint, FromFiveHundredMetresAnEdgeLiesWithinAFractionOfAPixel)
{
    for (const double east : {1000.3, 60000.7})
    {
        const double error = worstStripErrorPx(east, 31.0);
        EXPECT_LT(error, 0.15) << east;
        RecordProperty("worstPx", std::to_string(error));
    }
    EXPECT_GT(worstStripErrorPx(1000.3, 32.0), 0.2) << "a strip a metre wider is found out";
}

TEST(FeaturePaint, TheLaterKindLiesOnTop)
{
    const glm::dvec2 west(800.0, 20000.0), east(1200.0, 20000.0), south(1000.0, 19900.0),
        north(1000.0, 20050.0);
    const auto river = line(FeatureKind::river, 30.0, west, east);
    auto road = line(FeatureKind::road, 20.0, {960.0, 19800.0}, {1040.0, 20200.0});
    road.style.marked = false;
    const auto runway = line(FeatureKind::runway, 25.0, south, north);
    const auto middle = [](const std::vector<core::GroundFeature>& features)
    {
        Camera camera(plain(features));
        const auto picture = camera.picture({1000.0, 20000.0, 200.0}, -kZenith, kNorthward);
        const unsigned char* p = picture->data(kWidthPx / 2, kHeightPx / 2);
        return std::array<int, 3>{p[0], p[1], p[2]};
    };
    EXPECT_EQ(middle({road, river}), middle({road}));
    EXPECT_EQ(middle({runway, river, road}), middle({runway}));
    EXPECT_NE(middle({river}), middle({road}));
    EXPECT_NE(middle({runway}), middle({road}));
}

TEST(FeaturePaint, DoesNotSparkleWhenTheEyeMoves)
{
    const auto terrain = plain(roadsOfAPlain());
    const auto unfiltered = plain(roadsOfAPlain());
    mutate(*unfiltered,
           "return clamp(abs(dot(f.x, direction)) + abs(dot(f.y, direction)), 1e-3, 2.0 * kFeatureReachM);",
           "return 1e-3;");
    const osg::Vec3d driver(20005.0, 19950.0, 2.0), pilot(20000.0, 19700.0, 90.0);
    const osg::Vec3d level(0.1, 1.0, -0.05), down(0.1, 1.0, -0.2);
    const std::size_t low = flashes(terrain, driver, {0.0, 0.25, 0.0}, level);
    const std::size_t high = flashes(terrain, pilot, {0.3, 0.4, 0.0}, down);
    RecordProperty("driver", std::to_string(low));
    RecordProperty("pilot", std::to_string(high));
    EXPECT_LT(low, 20u) << "of 22 × 69 600 pixels";
    EXPECT_LT(high, 20u);
    EXPECT_GT(flashes(unfiltered, driver, {0.0, 0.25, 0.0}, level), 150u) << "without filters it does";
    EXPECT_GT(flashes(unfiltered, pilot, {0.3, 0.4, 0.0}, down), 2000u);
}

/// What stands for meshes near by is painted from a distance on. From 60 m above, a road 30 m wide near the
/// eye and one 200 m wide 2 km ahead.
TEST(FeaturePaint, IsLeftOutNearerThanTold)
{
    const std::vector roads = {line(FeatureKind::road, 30.0, {900.0, 20000.0}, {1100.0, 20000.0}),
                               line(FeatureKind::road, 200.0, {0.0, 22000.0}, {2000.0, 22000.0})};
    const auto levels = [&](double nearestM)
    {
        const auto terrain = plain(nearestM > 0.0 ? std::vector<core::GroundFeature>() : roads);
        if (nearestM > 0.0) terrain->material()->setFarFeatures(*core::FeatureCells::build(roads), nearestM);
        Camera camera(terrain);
        const osg::Vec3d eye(1000.0, 19850.0, 60.0);
        const auto picture = camera.picture(eye, osg::Vec3d(0.0, 1.0, -0.2), kZenith);
        const auto at = [&](const osg::Vec3d& place)
        {
            const osg::Vec2d pixel = camera.pixelOf(place);
            return level(*picture, static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
        };
        return std::array{at({1000.0, 20000.0, 0.0}), at({1000.0, 22000.0, 0.0}), at({1000.0, 20100.0, 0.0})};
    };
    const auto all = levels(0.0), far = levels(1000.0), none = levels(1e6);
    EXPECT_EQ(far[0], none[0]);
    EXPECT_LT(std::abs(far[1] - all[1]), 0.25 * std::abs(all[1] - none[1]))
        << "by the map of shares, which knows the mean of the marks only";
    EXPECT_EQ(far[2], all[2]) << "bare ground";
    EXPECT_NE(all[0], none[0]) << "else the test could not fail";
    EXPECT_NE(all[1], none[1]);
}

/// How much of what asphalt takes from bright snow a runway of 30 m takes 1 km behind its threshold, seen on
/// final approach 2 km before that: in the middle of the strip.
double runwayShareFromFinal(const std::string& mutated)
{
    const auto levelOf = [&](const std::vector<core::GroundFeature>& features)
    {
        const auto terrain = plain(features, true);
        if (!mutated.empty() && !features.empty()) mutate(*terrain, mutated, "if (false)");
        Camera camera(terrain);
        const auto picture = camera.picture({20000.0, 18000.0, 108.0}, osg::Vec3d(0.0, 1.0, -0.052), kZenith);
        const osg::Vec2d at = camera.pixelOf({20000.0, 21000.0, 0.0});
        return level(*picture, static_cast<int>(at.x()), static_cast<int>(at.y()));
    };
    const auto runway = [](double widthM) {
        return std::vector{line(FeatureKind::runway, widthM, {20000.0, 20000.0}, {20000.0, 21500.0})};
    };
    const double bare = levelOf({});
    return (bare - levelOf(runway(30.0))) / (bare - levelOf(runway(1000.0)));
}

TEST(FeaturePaint, ARunwayIsSeenFromFinal)
{
    const double seen = runwayShareFromFinal(""),
                 byMap = runwayShareFromFinal("if (featureRunwayCount >= 0)");
    EXPECT_GT(seen, 0.85) << "five pixels wide there";
    EXPECT_LT(byMap, 0.7) << "the control: the far map alone blurs it";
}

/// How much brighter than the asphalt beside it the marks of a runway are, in levels of its pixels: the
/// middle line's longest dash and the bars of the threshold, looked at from a height of 300 m. `define`: of a
/// quality.
std::array<double, 2> marksBesideAsphalt(const std::string& define, const std::string& mutated = "")
{
    const auto terrain = plain({line(FeatureKind::runway, 45.0, {20000.0, 20000.0}, {20000.0, 22000.0})});
    if (!define.empty()) terrain->material()->stateSet()->setDefine(define);
    if (!mutated.empty()) mutate(*terrain, mutated, "paint.marks.xw = vec2(0.0)");
    Camera camera(terrain);
    const auto spread = [&](double north)
    {
        const auto picture = camera.picture({20000.0, north, 300.0}, -kZenith, kNorthward);
        double least = 255.0, most = 0.0;
        // 40 m across and along: within the asphalt's edges.
        const osg::Vec2d low = camera.pixelOf({19980.0, north - 20.0, 0.0});
        const osg::Vec2d high = camera.pixelOf({20020.0, north + 20.0, 0.0});
        for (int y = static_cast<int>(low.y()); y < static_cast<int>(high.y()); ++y)
            for (int x = static_cast<int>(low.x()); x < static_cast<int>(high.x()); ++x)
            {
                least = std::min(least, level(*picture, x, y));
                most = std::max(most, level(*picture, x, y));
            }
        return most - least;
    };
    return {spread(21000.0), spread(20025.0)};
}

TEST(FeaturePaint, ARunwayHasItsMarksAtEveryQuality)
{
    const auto high = marksBesideAsphalt("");
    for (const char* define : {"PICTURE_MEDIUM", "PICTURE_LOW"})
    {
        const auto marks = marksBesideAsphalt(define);
        EXPECT_GT(marks[0], 0.8 * high[0]) << "middle line, " << define;
        EXPECT_GT(marks[1], 0.8 * high[1]) << "threshold, " << define;
    }
    const auto without = marksBesideAsphalt("PICTURE_LOW", "paint = mixed(listed, paint, far)");
    EXPECT_LT(without[0], 0.3 * high[0]) << "the control: the marks are left out";
    EXPECT_LT(without[1], 0.3 * high[1]);
}

/// How much brighter than asphalt the edge line and the middle line of a road are, in levels, from 12 m above
/// its right lane.
std::array<double, 2> linesBesideAsphalt(const std::string& define, const std::string& mutated = "")
{
    const auto terrain = plain({line(FeatureKind::road, 8.0, {20000.0, 19000.0}, {20000.0, 21000.0})});
    if (!define.empty()) terrain->material()->stateSet()->setDefine(define);
    if (!mutated.empty()) mutate(*terrain, mutated, "fract(list.z) > 1.0");
    Camera camera(terrain);
    const auto picture = camera.picture({20000.0, 20000.0, 12.0}, -kZenith, kNorthward);
    const auto brightest = [&](double east)
    {
        double most = 0.0;
        const osg::Vec2d low = camera.pixelOf({east - 0.2, 19996.0, 0.0}),
                         high = camera.pixelOf({east + 0.2, 20004.0, 0.0});
        for (int y = static_cast<int>(low.y()); y < static_cast<int>(high.y()); ++y)
            for (int x = static_cast<int>(low.x()); x <= static_cast<int>(high.x()); ++x)
                most = std::max(most, level(*picture, x, y));
        return most;
    };
    const double asphalt = brightest(20001.2);
    return {brightest(20003.69) - asphalt, brightest(20000.0) - asphalt};
}

/// How much redder than blue the line of a taxiway is, beside its asphalt, in levels, from 12 m above it.
double yellowOfTaxiway(const std::string& define, bool isMutated = false)
{
    core::GroundFeature taxiway = line(FeatureKind::road, 15.0, {20000.0, 19000.0}, {20000.0, 21000.0});
    taxiway.style.marked = false;
    taxiway.style.taxiing = core::Taxiing::taxiway;
    const auto terrain = plain({taxiway});
    if (!define.empty()) terrain->material()->stateSet()->setDefine(define);
    if (isMutated) mutate(*terrain, "paint.more.x += share", "paint.more.x += 0.0");
    Camera camera(terrain);
    const auto picture = camera.picture({20000.0, 20000.0, 12.0}, -kZenith, kNorthward);
    const auto warmest = [&](double east)
    {
        const osg::Vec2d at = camera.pixelOf({east, 20000.0, 0.0});
        double most = -255.0;
        for (int x = static_cast<int>(at.x()) - 3; x <= static_cast<int>(at.x()) + 3; ++x)
        {
            const unsigned char* const pixel = picture->data(x, static_cast<int>(at.y()));
            most = std::max(most, static_cast<double>(pixel[0]) - pixel[2]);
        }
        return most;
    };
    return warmest(20000.0) - warmest(20003.0);
}

TEST(FeaturePaint, ATaxiwayHasItsYellowLineAtEveryQuality)
{
    for (const char* define : {"", "PICTURE_MEDIUM", "PICTURE_LOW"})
    {
        EXPECT_GT(yellowOfTaxiway(define), 40.0) << define;
        EXPECT_LT(yellowOfTaxiway(define, true), 8.0) << "the mutation: no stroke paints it; " << define;
    }
}

/// How much darker the middle of a runway is where aircraft touch down than halfway, in levels of the mean
/// over 4 m by 80 m, between the strokes of the middle line; from a height.
double darkerWhereTheyTouchDown(double heightM, bool isMutated = false)
{
    const auto terrain = plain({line(FeatureKind::runway, 45.0, {20000.0, 20000.0}, {20000.0, 22000.0})});
    if (isMutated) mutate(*terrain, "0.55 * paint.more.y", "0.0 * paint.more.y");
    Camera camera(terrain);
    const auto mean = [&](double north)
    {
        const auto picture = camera.picture({20000.0, north, heightM}, -kZenith, kNorthward);
        double sum = 0.0;
        int count = 0;
        const osg::Vec2d low = camera.pixelOf({19998.0, north - 40.0, 0.0}),
                         high = camera.pixelOf({20002.0, north + 40.0, 0.0});
        for (int y = static_cast<int>(low.y()); y < static_cast<int>(high.y()); ++y)
            for (int x = static_cast<int>(low.x()); x <= static_cast<int>(high.x()); ++x, ++count)
                sum += level(*picture, x, y);
        return sum / std::max(count, 1);
    };
    return mean(21000.0) - mean(20350.0);
}

TEST(FeaturePaint, TyresLeaveRubberWhereTheyTouchDown)
{
    const auto darkerBy = [](double heightM)
    { return darkerWhereTheyTouchDown(heightM) - darkerWhereTheyTouchDown(heightM, true); };
    EXPECT_GT(darkerBy(150.0), 5.0);
    EXPECT_GT(darkerBy(4000.0), 2.0) << "pixels of 12 m, by the map of far features";
}

/// A field of grass of 320 m.
core::GroundFeature fieldAt(const glm::dvec2& corner)
{
    core::GroundFeature field;
    field.style.kind = FeatureKind::field;
    field.style.crop = core::Crop::grassland;
    field.style.isCropKnown = true;
    field.isArea = true;
    field.paths = {{corner, corner + glm::dvec2(320.0, 0.0), corner + glm::dvec2(320.0, 320.0),
                    corner + glm::dvec2(0.0, 320.0)}};
    return field;
}

/// By how many levels fields of one crop differ, from 1 km and 12 km above them: standard deviations.
std::array<double, 2> spreadOfFields(const std::string& define, bool isMutated = false)
{
    constexpr int kFields = 6;
    std::vector<core::GroundFeature> fields;
    std::vector<osg::Vec3d> middles;
    for (int i = 0; i < kFields * kFields; ++i)
    {
        const glm::dvec2 corner = glm::dvec2(19000.0, 19000.0) + 330.0 * glm::dvec2(i % kFields, i / kFields);
        fields.push_back(fieldAt(corner));
        middles.emplace_back(corner.x + 160.0, corner.y + 160.0, 0.0);
    }
    const auto terrain = plain(fields);
    if (!define.empty()) terrain->material()->stateSet()->setDefine(define);
    if (isMutated) mutate(*terrain, "0.75 + 0.5 * shade", "1.0");
    const auto spread = [&](double heightM)
    {
        Camera camera(terrain);
        double sum = 0.0, squares = 0.0;
        for (const osg::Vec3d& middle : middles)
        {
            // Near by, each for itself; the grain is averaged over a square of pixels.
            const auto picture = camera.picture({middle.x(), middle.y(), heightM}, -kZenith, kNorthward);
            const int half = heightM > 5000.0 ? 3 : 20;
            double mean = 0.0;
            for (int y = -half; y <= half; ++y)
                for (int x = -half; x <= half; ++x)
                    mean += level(*picture, kWidthPx / 2 + x, kHeightPx / 2 + y) / std::pow(2 * half + 1, 2);
            sum += mean / kFields / kFields;
            squares += mean * mean / kFields / kFields;
        }
        return std::sqrt(std::max(squares - sum * sum, 0.0));
    };
    return {spread(1000.0), spread(12000.0)};
}

/// The far map of beds has no shades of fields, which would be runways there.
TEST(FeaturePaint, FieldsAmongFarFeaturesPaintNothing)
{
    const auto bare = plain({}), terrain = plain({});
    terrain->material()->setFarFeatures(*core::FeatureCells::build({fieldAt({19840.0, 19840.0})}), 1.0);
    const osg::Vec3d eye(20000.0, 20000.0, 1000.0);
    Camera camera(terrain), bareCamera(bare);
    EXPECT_NEAR(level(*camera.picture(eye, -kZenith, kNorthward), kWidthPx / 2, kHeightPx / 2),
                level(*bareCamera.picture(eye, -kZenith, kNorthward), kWidthPx / 2, kHeightPx / 2), 1.0);
}

TEST(FeaturePaint, FieldsDifferAsMuchFromFarAwayAsFromNearBy)
{
    for (const char* define : {"", "PICTURE_LOW"})
    {
        const auto spread = spreadOfFields(define);
        EXPECT_GT(spread[0], 5.0) << define;
        EXPECT_GT(spread[1], 0.8 * spread[0]) << define;
        EXPECT_LT(spread[1], 1.2 * spread[0]) << define;
        EXPECT_LT(spreadOfFields(define, true)[1], 0.5 * spread[1]) << "the control: by the crop alone";
    }
}

TEST(FeaturePaint, ARoadHasItsLinesAtEveryQuality)
{
    const auto high = linesBesideAsphalt("");
    EXPECT_GT(high[0], 40.0);
    EXPECT_GT(high[1], 40.0);
    for (const char* define : {"PICTURE_MEDIUM", "PICTURE_LOW"})
    {
        const auto lines = linesBesideAsphalt(define);
        EXPECT_GT(lines[0], 0.8 * high[0]) << "edge line, " << define;
        EXPECT_GT(lines[1], 0.8 * high[1]) << "middle line, " << define;
    }
    const auto byMap = linesBesideAsphalt("PICTURE_LOW", "fract(list.z) > 0.25");
    EXPECT_LT(byMap[0], 0.3 * high[0]) << "the control: by the maps alone there are none";
    EXPECT_LT(byMap[1], 0.3 * high[1]);
}

TEST(FeaturePaint, NothingOfItIsDrawnWhereNothingIsPainted)
{
    const auto far = plain({line(FeatureKind::road, 8.0, {50000.0, 50000.0}, {50500.0, 50000.0})});
    Camera with(far), without(plain({}));
    const osg::Vec3d eye(20000.0, 20000.0, 100.0), ahead(0.0, 1.0, -0.4);
    const auto difference = osgOffscreen::compareImages(*with.picture(eye, ahead, kZenith),
                                                        *without.picture(eye, ahead, kZenith));
    EXPECT_TRUE(difference.identical()) << difference.message();
}
