// SPDX-License-Identifier: Apache-2.0
// Everything stands by its rules, and where it stands follows from what was asked alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "SceneryPlaces.h"
#include "scenery/placement/Footing.h"

namespace
{

using namespace scenerytest;
using testing::HasSubstr;

class PlacedVillage : public testing::Test
{
protected:
    SceneryDescription _description = village();
    std::vector<Measures> _measures = measuresFor(_description);
    Ground _ground = hills();
    Ways _ways = ways();

    PlacedScenery place() const { return placeScenery(_description, _measures, _ground, _ways); }
    std::string defect(const PlacedScenery& placed) const
    {
        return defectOf(placed, _description, _measures, _ground, _ways);
    }
};

TEST_F(PlacedVillage, HoldsAllRules)
{
    const PlacedScenery placed = place();
    EXPECT_EQ(defect(placed), "");
    ASSERT_EQ(placed.reports.size(), 4u);
    EXPECT_EQ(placed.reports[0].placed, 3000u);
    EXPECT_GT(placed.reports[1].placed, 20u);
    EXPECT_EQ(placed.reports[2].placed, 30u);
    EXPECT_EQ(placed.reports[3].placed, 200u);
    EXPECT_GE(placed.streets.size(), 2u);
    EXPECT_EQ(placed.placements.size(), 3000u + placed.reports[1].placed + 230u);
}

TEST_F(PlacedVillage, IsTheSameEveryTimeAndInAnyOrderOfItsFields)
{
    const PlacedScenery first = place();
    EXPECT_EQ(place().placements, first.placements);
    std::swap(_description.fields[0], _description.fields[1]);
    _measures = measuresFor(_description);
    const PlacedScenery swapped = place();
    ASSERT_EQ(swapped.placements.size(), first.placements.size());
    for (std::size_t i = 0; i < first.placements.size(); ++i)
        EXPECT_EQ(swapped.placements[i].position, first.placements[i].position);
    _description.seed = 6;
    EXPECT_NE(place().placements, swapped.placements);
}

/// Mutations: the check finds whatever breaks a rule.
TEST_F(PlacedVillage, IsNoneAnyMoreWhenAnObjectIsMoved)
{
    const PlacedScenery placed = place();
    PlacedScenery wrong = placed;
    wrong.placements[7].position.x = wrong.placements[8].position.x + 0.1;
    wrong.placements[7].position.y = wrong.placements[8].position.y;
    EXPECT_THAT(defect(wrong), HasSubstr("overlap"));
    wrong = placed;
    wrong.placements.back().position.z += 1.0;
    EXPECT_THAT(defect(wrong), HasSubstr("floats"));
    wrong.placements.back().position.z -= 2.0;
    EXPECT_THAT(defect(wrong), HasSubstr("buried"));
    wrong = placed;
    wrong.placements.back().scale = 2.0;
    EXPECT_NE(defect(wrong), "");
    for (const Placement& p : placed.placements)
        if (p.field == 0) // a way where a tree stands
        {
            _ways.keepClear.push_back({{glm::dvec2(p.position)}, 1.0});
            break;
        }
    EXPECT_THAT(defect(placed), HasSubstr("way"));
}

TEST_F(PlacedVillage, IsNoneAnyMoreWhenARuleIsTighter)
{
    const PlacedScenery placed = place();
    _description.fields[0].where.circle->radiusM = 1000.0;
    EXPECT_THAT(defect(placed), HasSubstr("circle"));
    _description = village();
    _description.fields[0].where.covers = {"forest"};
    EXPECT_THAT(defect(placed), HasSubstr("cover"));
    EXPECT_EQ(defect(place()), "");
    _description = village();
    _ground.seaLevelM = 60.0;
    EXPECT_THAT(defect(placed), HasSubstr("water"));
    EXPECT_EQ(defect(place()), "");
    _ground.seaLevelM = 0.0;
    _description.fields[0].crowding = 0.0; // crowns may not grow into each other any more
    EXPECT_THAT(defect(placed), HasSubstr("overlap"));
}

TEST_F(PlacedVillage, FacesItsStreets)
{
    const PlacedScenery placed = place();
    for (const Placement& p : placed.placements)
    {
        if (p.field != 1) continue;
        // Before the entrance, -y, is a street within a few steps.
        const glm::dvec2 door(p.position - p.axes[1] * 13.0);
        double nearest = 1e9;
        for (const Corridor& street : placed.streets)
        {
            const glm::dvec2 along = street.line[1] - street.line[0];
            const double t =
                std::clamp(glm::dot(door - street.line[0], along) / glm::dot(along, along), 0.0, 1.0);
            nearest = std::min(nearest, glm::length(door - street.line[0] - t * along));
        }
        EXPECT_LT(nearest, 6.0);
    }
}

TEST_F(PlacedVillage, StaysShortWhereThereIsNoRoom)
{
    _description.fields[0].where.circle = Circle{{0.0, 0.0}, 50.0};
    const PlacedScenery placed = place();
    EXPECT_LT(placed.reports[0].placed, 200u);
    EXPECT_EQ(defect(placed), "");
}

TEST_F(PlacedVillage, FindsNothingBeyondTheGroundOrWithoutAPath)
{
    _description.fields[0].where.circle = Circle{{90000.0, 0.0}, 500.0};
    _ways = {};
    const PlacedScenery placed = place();
    EXPECT_EQ(placed.reports[0].placed, 0u);
    EXPECT_EQ(placed.reports[3].placed, 0u); // near a path
    _ground.heightM = [](const glm::dvec2&) -> std::optional<double> { return std::nullopt; };
    EXPECT_TRUE(place().placements.empty());
}

TEST_F(PlacedVillage, IsAsDenseAsAskedFor)
{
    SceneryField& wood = _description.fields[0];
    wood.count = 0;
    wood.densityPerKm2 = 100.0;
    wood.where.circle->radiusM = 1000.0;
    EXPECT_NEAR(place().reports[0].wanted, 314.0, 12.0);
}

TEST_F(PlacedVillage, HasPatches)
{
    _description.fields.resize(1);
    SceneryField& wood = _description.fields[0];
    wood.where.patchShare = 0.3;
    const PlacedScenery placed = place();
    // Squares of 100 m are full or empty far more often than if trees stood anywhere (then 4 in 100 would be
    // empty).
    std::map<std::pair<int, int>, int> squares;
    for (const Placement& p : placed.placements)
        ++squares[{static_cast<int>(std::floor(p.position.x / 100.0)),
                   static_cast<int>(std::floor(p.position.y / 100.0))}];
    EXPECT_LT(squares.size(), 1400u); // of 1963
}

} // namespace
