// SPDX-License-Identifier: Apache-2.0
// What can be said in a scenery's file, and what is said of what cannot.
#include "scenery/placement/ReadScenery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{

using namespace scenery;
using osgPMObjects::core::SelectionMethod;
using testing::AllOf;
using testing::HasSubstr;

/// A field with more members.
std::string fieldWith(const std::string& members)
{
    return R"({"fields": [{"name": "f", "objects": [{"kind": "oak"}], "count": 1, "where": {"circle":
        {"eastM": 1, "northM": 2, "radiusM": 3}})" +
           (members.empty() ? "" : ", " + members) + "}]}";
}

std::string complaint(const std::string& text)
{
    const auto read = parseScenery(text, "folder/s.json");
    return read ? "" : read.error().message();
}

TEST(ReadScenery, TakesEverythingOfAField)
{
    const auto read = parseScenery(R"({"seed": 7, "budget": {"triangles": 50000}, "fields": [
        {"name": "avenue", "arrangement": "rows", "densityPerKm2": 12.5,
         "objects": [{"kind": "poplar", "seeds": [3, 4]}, {"file": "tree.pm"}],
         "where": {"polygonM": [0, 0, 10, 0, 10, 10], "pathDistanceM": [5, 50], "heightM": [1, 2], "slopeDeg": [0, 9],
                   "inWater": true, "covers": ["meadow"], "patchM": 80, "patchShare": 0.25},
         "rows": {"rows": 3, "spacingM": 8, "betweenM": 7, "lengthM": 60}, "spacingM": 1.5, "crowding": 0.3,
         "scale": [0.5, 2], "importance": 3,
         "selection": {"method": "overlapping-ranges", "boundariesM": [50, 200], "facesPercent": [100, 30, 5],
                       "overlap": 1.5, "leastFaces": 24, "alpha": {"fadeM": 900, "goneM": 1000}},
         "switching": {"method": "blend", "profile": "cross", "durationS": 0.7, "staggerS": 0.1}}]})",
                                   "folder/s.json");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->seed, 7u);
    EXPECT_EQ(read->budget.budget, 50000u);
    const SceneryField& field = read->fields.front();
    EXPECT_EQ(field.arrangement, Arrangement::rows);
    ASSERT_EQ(field.objects.size(), 3u);
    EXPECT_EQ(field.objects[1].seed, 4u);
    EXPECT_EQ(field.objects[2].file, "folder/tree.pm");
    EXPECT_EQ(field.selection.settings.leastFaces, 24u);
    EXPECT_EQ(field.where.polygon.size(), 3u);
    EXPECT_EQ(field.where.pathDistanceM->most, 50.0);
    EXPECT_TRUE(field.where.inWater);
    EXPECT_EQ(field.rows.rows, 3);
    EXPECT_EQ(field.selection.settings.method, SelectionMethod::overlappingRanges);
    EXPECT_EQ(field.selection.settings.alpha.goneM, 1000.0);
    EXPECT_EQ(field.switching.method, osgPMObjects::core::SwitchMethod::blend);
    EXPECT_EQ(field.switching.profile, osgPMObjects::core::BlendProfile::cross);
    EXPECT_FLOAT_EQ(field.switching.durationS, 0.7F);
    EXPECT_EQ(field.importance, 3.0);
    EXPECT_EQ(objectsOf(*read).size(), 3u);
}

TEST(ReadScenery, KnowsEveryMethodOfSelectionBySelectionsOwnName)
{
    for (std::size_t i = 0; i < osgPMObjects::core::kSelectionMethods; ++i)
    {
        const auto method = static_cast<SelectionMethod>(i);
        const auto read = parseScenery(
            fieldWith(
                std::string(R"("selection": {"facesPercent": [100, 10], "boundariesM": [50], "leastPx": [10],
                "method": ")") +
                osgPMObjects::core::nameOf(method) + "\"}"),
            "s.json");
        ASSERT_TRUE(read) << read.error().message();
        EXPECT_EQ(read->fields[0].selection.settings.method, method);
    }
}

TEST(ReadScenery, CountsABudgetInMillisecondsAsNanoseconds)
{
    const auto read = parseScenery(R"({"budget": {"ms": 4, "nsPerTriangle": 80}, "fields": []})", "s.json");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->budget.budget, 4000000u);
    EXPECT_EQ(read->budget.cost.perTriangle, 80.0);
}

TEST(ReadScenery, SaysWhereAMistakeIsAndWhatToDo)
{
    EXPECT_EQ(complaint(fieldWith("")), "");
    EXPECT_THAT(complaint("{\n\"fields\": [\n}"), AllOf(HasSubstr("s.json:3"), HasSubstr("no JSON")));
    EXPECT_THAT(complaint("[]"), HasSubstr("no object"));
    EXPECT_THAT(complaint("{}"), HasSubstr("/fields"));
    EXPECT_THAT(complaint(fieldWith(R"("colour": 1)")),
                AllOf(HasSubstr("/fields/0/colour"), HasSubstr("known:")));
    EXPECT_THAT(complaint(fieldWith(R"("spacingM": "far")")), HasSubstr("/fields/0/spacingM: is no number"));
    EXPECT_THAT(complaint(fieldWith(R"("crowding": 2)")), HasSubstr("from 0 to 0.8"));
    EXPECT_THAT(complaint(fieldWith(R"("scale": [2, 1])")), HasSubstr("no range"));
    EXPECT_THAT(complaint(fieldWith(R"("densityPerKm2": 2)")), HasSubstr("either count or density"));
    EXPECT_THAT(complaint(fieldWith(R"("arrangement": "heap")")), HasSubstr("scattered"));
    EXPECT_THAT(complaint(fieldWith(R"("arrangement": "parked")")), HasSubstr("names no settlement"));
    EXPECT_THAT(complaint(fieldWith(R"("selection": {"method": "ranges", "boundariesM": [5, 4]})")),
                HasSubstr("/fields/0/selection/boundariesM: does not rise"));
    EXPECT_THAT(complaint(fieldWith(R"("selection": {"method": "ranges", "boundariesM": [5]})")),
                HasSubstr("facesPercent"));
    EXPECT_THAT(complaint(fieldWith(R"("selection": {"alpha": {"fadeM": 5, "goneM": 4}})")),
                HasSubstr("goneM"));
    EXPECT_THAT(complaint(fieldWith(R"("selection": {"leastFaces": 1.5})")), HasSubstr("is no whole number"));
    EXPECT_THAT(complaint(R"({"budget": {}, "fields": []})"), HasSubstr("triangles or ms"));
    EXPECT_THAT(complaint(R"({"fields": [{"name": "f", "objects": [{"kind": "rose"}], "count": 1}]})"),
                AllOf(HasSubstr("/fields/0/objects/0/kind"), HasSubstr("oak")));
    EXPECT_THAT(complaint(R"({"fields": [{"name": "f", "objects": [{"kind": "oak"}], "count": 1}]})"),
                HasSubstr("does not say where"));
    EXPECT_THAT(complaint(std::string(200000, '[')), HasSubstr("no JSON"));
}

TEST(ReadScenery, SaysThatAFileIsNotThere)
{
    const auto read = readScenery("no/such/file.json");
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().message(), HasSubstr("no/such/file.json"));
}

} // namespace
