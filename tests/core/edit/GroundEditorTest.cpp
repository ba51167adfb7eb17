// SPDX-License-Identifier: Apache-2.0
// Edits by shapes: the ground afterwards, inside and around each shape.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/edit/GroundEditor.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include "DesignedRoad.h"
#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

/// 33 samples a side, 30 m apart; with `gridExponent` 5, 1024 grid steps of 0.94 m.
struct Site
{
    /// `relief`: factor of the hills' heights, which are too steep for roads at 1.
    explicit Site(int gridExponent = 5, bool curved = false, float relief = 1.0f)
        : tile(tileOf(gridExponent, curved, relief)), before(tileOf(gridExponent, curved, relief))
    {
    }

    static std::shared_ptr<RoamTile> tileOf(int gridExponent, bool curved, float relief)
    {
        HeightField field = testsupport::hills(33, 33);
        for (float& heightM : field.heightsM)
            heightM *= relief;
        if (curved) field = testsupport::onTheEarth(std::move(field));
        return std::make_shared<RoamTile>(
            PlacedTile(std::move(field), {.placement = curved ? Placement::curved : Placement::planar,
                                          .gridExponent = gridExponent}));
    }

    static double heightAt(const RoamTile& of, double x, double y)
    {
        const auto ground = groundAt(of.tile, x, y);
        return ground ? of.tile.frame().heightOf(ground->position) : -1e9;
    }
    double heightAt(double x, double y) const { return heightAt(*tile, x, y); }
    double heightBefore(double x, double y) const { return heightAt(*before, x, y); }

    std::shared_ptr<RoamTile> tile, before;
};

TEST(GroundEditor, SetsAndRaisesRegions)
{
    const Site site;
    GroundEditor editor(site.tile);
    ASSERT_TRUE(editor.setHeight(Region::circle({500, 500}, 40.0), 321.5));
    EXPECT_NEAR(site.heightAt(500, 500), 321.5, 1e-3);
    EXPECT_NEAR(site.heightAt(535, 500), 321.5, 1e-3);
    EXPECT_NEAR(site.heightAt(545, 500), site.heightBefore(545, 500), 1e-3);
    editor.setFadeM(20.0);
    ASSERT_TRUE(editor.raise(Region::polygon({{200, 200}, {300, 200}, {300, 300}, {200, 300}}), 5.0));
    EXPECT_NEAR(site.heightAt(250, 250), site.heightBefore(250, 250) + 5.0, 1e-3);
    EXPECT_NEAR(site.heightAt(210, 250), site.heightBefore(210, 250) + 2.5, 0.2) << "half-way in";
    EXPECT_NEAR(site.heightAt(195, 250), site.heightBefore(195, 250), 1e-3);
    while (editor.undo())
    {
    }
    EXPECT_EQ(site.heightAt(500, 500), site.heightBefore(500, 500));
}

TEST(GroundEditor, SmoothsAndFlattens)
{
    const Site site;
    GroundEditor editor(site.tile);
    const auto roughness = [&](double x, double y)
    {
        double sum = 0.0;
        for (int i = -3; i <= 3; ++i)
            sum += std::abs(site.heightAt(x + 30.0 * i, y) - 2.0 * site.heightAt(x + 30.0 * i + 15.0, y) +
                            site.heightAt(x + 30.0 * i + 30.0, y));
        return sum;
    };
    const double rough = roughness(400, 400);
    ASSERT_TRUE(editor.smooth(Region::circle({400, 400}, 200.0), 60.0));
    EXPECT_LT(roughness(400, 400), 0.5 * rough);
    ASSERT_TRUE(editor.flatten(Region::circle({700, 700}, 60.0)));
    const double slopeX = site.heightAt(720, 700) - site.heightAt(700, 700);
    EXPECT_NEAR(site.heightAt(740, 700) - site.heightAt(720, 700), slopeX, 0.01) << "a plane";
    EXPECT_NEAR(site.heightAt(680, 715), site.heightAt(700, 715) - slopeX, 0.01);
}

TEST(GroundEditor, StampsACrater)
{
    const Site site;
    GroundEditor editor(site.tile);
    ASSERT_TRUE(editor.stamp({.centre = {480, 510}, .radiusM = 12.0, .depthM = 4.0, .rimM = 1.0}));
    const auto by = [&](double x) { return site.heightAt(x, 510) - site.heightBefore(x, 510); };
    EXPECT_NEAR(by(480), -4.0, 0.05);
    EXPECT_NEAR(by(492), 1.0, 0.2);
    EXPECT_GT(by(500), 0.1);
    EXPECT_NEAR(by(480 + 37), 0.0, 1e-3);
}

/// Within the width the ground is as designed, beside it no steeper than the slope, and far away unchanged.
TEST(GroundEditor, ARoadIsExactToACentimetre)
{
    for (const bool curved : {false, true})
    {
        const Site site(6, curved, 0.15f);
        GroundEditor editor(site.tile);
        const auto at = [&](double column, double row)
        { return glm::dvec2(site.tile->tile.frame().positionAt(column * 64.0, row * 64.0, 60.0)); };
        Ribbon road{.smoothM = 300.0};
        for (int i = 0; i <= 24; ++i)
            road.points.push_back(at(8.0 + 0.5 * i, 16.0 + 4.0 * std::sin(0.25 * i)));
        const DesignedRoad designed(road, editor);
        ASSERT_TRUE(editor.conform(designed.ribbon()));
        EXPECT_LT(designed.worstM(*site.tile, 1.7, std::array{-3.4, -1.0, 0.0, 2.0, 3.4}), 0.01)
            << (curved ? "curved" : "planar");
        const glm::dvec2 far = at(4, 3);
        EXPECT_EQ(site.heightAt(far.x, far.y), site.heightBefore(far.x, far.y));
    }
}

TEST(GroundEditor, EmbankmentsKeepTheirSlope)
{
    const Site site;
    GroundEditor editor(site.tile);
    const double level = site.heightBefore(500, 500) + 12.0;
    ASSERT_TRUE(editor.conform(
        Platform{.corners = {{460, 460, level}, {540, 460, level}, {540, 540, level}, {460, 540, level}}}));
    EXPECT_NEAR(site.heightAt(465, 535), level, 0.01);
    double steepest = 0.0;
    for (double x = 541.0; x < 600.0; x += 1.0)
        if (site.heightAt(x, 500) > site.heightBefore(x, 500) + 0.5)
            steepest = std::max(steepest, site.heightAt(x, 500) - site.heightAt(x + 1.0, 500));
    EXPECT_GT(steepest, 0.5);
    EXPECT_LT(steepest, 1.0 / 1.5 + 0.05);
}

TEST(GroundEditor, ARibbonWithoutHeightsFollowsTheGroundSmoothly)
{
    const Site site;
    GroundEditor editor(site.tile);
    const Ribbon road{.points = {{150, 150}, {500, 300}, {850, 800}}};
    const PlanLine line(road.points);
    ASSERT_TRUE(editor.conform(road));
    for (double s = 40.0; s < line.lengthM() - 40.0; s += 5.0)
    {
        const glm::dvec2 p = line.at(s), next = line.at(s + 1.0);
        EXPECT_LT(std::abs(site.heightAt(p.x, p.y) - site.heightBefore(p.x, p.y)), 60.0);
        const glm::dvec2 far = line.at(s + 10.0), farther = line.at(s + 11.0);
        const double slope = site.heightAt(next.x, next.y) - site.heightAt(p.x, p.y);
        const double later = site.heightAt(farther.x, farther.y) - site.heightAt(far.x, far.y);
        EXPECT_LT(std::abs(later - slope), 0.25) << s;
    }
}

TEST(GroundEditor, OnTheRasterAloneItChangesSamplesOnly)
{
    const Site site(0);
    GroundEditor editor(site.tile);
    ASSERT_TRUE(editor.raise(Region::circle({480, 480}, 100.0), 10.0));
    EXPECT_TRUE(site.tile->tile.samples().fineSamples().isEmpty());
    EXPECT_NEAR(site.heightAt(480, 480), site.heightBefore(480, 480) + 10.0, 0.01);
}

TEST(GroundEditor, RefusesShapesThatAreNone)
{
    const Site site;
    GroundEditor editor(site.tile);
    EXPECT_FALSE(editor.raise(Region::circle({500, 500}, 0.0), 1.0));
    EXPECT_FALSE(editor.flatten(Region::polygon({{1, 2}, {3, 4}})));
    EXPECT_FALSE(editor.stamp({.radiusM = -1.0}));
    EXPECT_FALSE(editor.conform(Ribbon{.points = {{1, 2}}}));
    EXPECT_FALSE(editor.conform(Ribbon{.points = {{1, 2}, {30, 40}}, .heightsM = {1.0}}));
    EXPECT_FALSE(editor.conform(Platform{.corners = {{1, 2, 3}, {4, 5, 6}, {9, 5, 6}}, .slope = 0.0}));
    EXPECT_FALSE(editor.raise(Region::circle({1e7, 500}, 10.0), 1.0)) << "beyond the data";
    EXPECT_FALSE(editor.raise(Region::circle({500, 500}, 20.0), 1e6)) << "no such height";
    EXPECT_EQ(editor.steps().undoSteps(), 0u);
}

} // namespace
