// SPDX-License-Identifier: Apache-2.0
// Plays with a scenery: the same every time, in the statistics, and errors that name their place.
#include "Playing.h"

namespace
{

/// Bushes beside the way, the cheapest models to make, and cars.
constexpr const char* kScenery = R"({"budget": {"triangles": 20000}, "fields": [
    {"name": "bushes", "count": 300, "objects": [{"kind": "barn"}], "scale": [0.2, 0.4],
     "where": {"pathDistanceM": [0, 600], "slopeDeg": [0, 45]}, "selection": {"method": "budget"}},
    {"name": "barns", "count": 20, "objects": [{"kind": "barn"}], "where": {"pathDistanceM": [0, 900]},
     "selection": {"method": "ranges", "boundariesM": [100, 400], "facesPercent": [100, 30, 5]},
     "switching": {"method": "blend"}}]})";

TEST(SceneryPlay, IsTheSameEveryTimeAndNotThatWithoutScenery)
{
    const Workplace place;
    place.write("s.json", kScenery);
    const std::vector<std::string> tour{"tour", place.hill()}, with{"--scenery", place.path("s.json")};
    const Playing a = playedAs(place, "a", tour, with), b = playedAs(place, "b", tour, with),
                  without = playedAs(place, "c", tour);
    EXPECT_TRUE(a.frames == b.frames) << "the pictures differ";
    EXPECT_EQ(withoutMeasured(a.statistics), withoutMeasured(b.statistics));
    EXPECT_FALSE(a.frames == without.frames) << "nothing of the scenery is seen";
    const auto& frame = a.statistics["frames"][3];
    EXPECT_GT(frame["objectsDrawn"], 10);
    EXPECT_GT(frame["objectTriangles"], 100);
    EXPECT_GT(frame["objectMethods"]["budget"]["objects"], 0);
    EXPECT_TRUE(frame["objectMethods"]["budget"]["fits"]);
    EXPECT_FALSE(without.statistics["frames"][3].contains("objectsDrawn"));
}

TEST(SceneryPlay, SaysWhatIsWrongWithAScenery)
{
    const Workplace place;
    place.write("wrong.json", R"({"fields": [{"name": "x", "objects": [{"kind": "rose"}], "count": 1}]})");
    const auto run = [&](const std::vector<std::string>& more)
    {
        std::vector<std::string> arguments{"tour", place.hill(), "--size", "64x36", "--frames", "1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runTrainer(arguments);
    };
    EXPECT_TRUE(failsWith(run({"--scenery", place.path("wrong.json")}), 1, "trainer",
                          {"wrong.json", "/fields/0/objects/0/kind", "oak"}));
    EXPECT_TRUE(failsWith(run({"--scenery", place.path("none.json")}), 1, "trainer", {"none.json"}));
    EXPECT_TRUE(
        failsWith(run({"--objects", place.path("no-folder")}), 1, "trainer", {"no-folder", "no model"}));
    place.write("gone.json", R"({"fields": [{"name": "x", "objects": [{"file": "gone.pm"}], "count": 1,
        "where": {"pathDistanceM": [0, 50]}}]})");
    EXPECT_TRUE(failsWith(run({"--scenery", place.path("gone.json")}), 1, "trainer", {"gone.pm"}));
}

TEST(SceneryPlay, TakesModelsOfAFolder)
{
    const Workplace place;
    std::filesystem::create_directory(place.path("models"));
    place.write("models/tent.obj", "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nv 0 0 3\n"
                                   "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 4 3 2\nf 4 2 1\n");
    const Playing played = playedAs(place, "a", {"tour", place.hill()}, {"--objects", place.path("models")});
    EXPECT_GT(played.statistics["frames"][3]["objectsDrawn"], 3);
}

} // namespace
