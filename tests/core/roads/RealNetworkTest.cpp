// SPDX-License-Identifier: Apache-2.0
// Networks that others made: read without an error, closed at their joints, and the same both ways.
#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <zlib.h>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/query/GeoReference.h>
#include <osgRoads/core/query/LaneRoute.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadLocator.h>
#include <osgRoads/core/query/RoadSurface.h>

#include "RealData.h"
#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;

std::vector<std::filesystem::path> networksIn(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".xodr") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string unzipped(const std::filesystem::path& file)
{
    std::string text;
    const gzFile stream = gzopen(file.c_str(), "rb");
    if (!stream) return text;
    std::vector<char> block(1 << 20);
    for (int count = 0; (count = gzread(stream, block.data(), static_cast<unsigned>(block.size()))) > 0;)
        text.append(block.data(), static_cast<std::size_t>(count));
    gzclose(stream);
    return text;
}

/// Whether a road folds over itself at t near s: lanes reach beyond the centre of a bend, where s and t are
/// not unique.
bool isFolded(const Road& road, double s, double t)
{
    const double from = std::max(s - 10.0, 0.0), to = std::min(s + 10.0, road.length);
    for (int i = 0; i <= 400; ++i)
    {
        const double on = from + (to - from) * i / 400.0;
        if (1.0 - road.referenceLine.at(on).curvature * t < 0.1) return true;
    }
    return false;
}

/// Road → world → road at random positions on lanes. Roads lie over each other in junctions, so the answer
/// may be another road that is as near; then it must be the same place.
void expectBothWays(const RoadNetwork& network, std::size_t positions)
{
    const RoadLocator locator(network);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.001, 0.999);
    std::size_t same = 0, asked = 0, folded = 0;
    while (asked < positions)
    {
        const std::size_t index = random() % network.roads.size();
        const Road& road = network.roads[index];
        if (!road.isUsable || road.sections.empty()) continue;
        const double s = share(random) * road.length;
        const RoadExtent extent = extentAt(road, s);
        const double t = extent.rightT + share(random) * (extent.leftT - extent.rightT);
        if (isFolded(road, s, t) && ++folded < positions) continue;
        ++asked;
        const glm::dvec3 point = surfacePoint(road, s, t);
        const auto found = locator.nearest(point);
        ASSERT_TRUE(found);
        EXPECT_LE(found->distance, 1e-6) << "road " << road.id << " s " << s << " t " << t;
        const auto all = locator.within(glm::dvec2(point), 1e-6);
        const bool isListed = std::any_of(all.begin(), all.end(),
                                          [&](const RoadMatch& match)
                                          { return match.position.road == static_cast<int>(index); });
        EXPECT_TRUE(isListed) << "road " << road.id << " s " << s << " t " << t;
        const glm::dvec3 back = worldPosition(network, found->position);
        EXPECT_LT(glm::length(back - point), 1e-6) << "road " << road.id << " s " << s << " t " << t;
        if (found->position.road == static_cast<int>(index)) ++same;
    }
    EXPECT_GT(same, positions / 2);
    EXPECT_LT(folded, positions / 5);
}

TEST(RealNetwork, EveryFileIsRead)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "openscenario");
    const auto files = networksIn(folder);
    ASSERT_EQ(files.size(), 22u);
    for (const auto& file : files)
    {
        const auto read = readNetwork(file);
        ASSERT_TRUE(read) << read.error().message();
        for (const Road& road : read->network.roads)
            EXPECT_TRUE(road.isUsable) << file << " road " << road.id;
        for (const Flaw& flaw : checkElementJoints(read->network))
            ADD_FAILURE() << flaw.message(file.filename());
        expectBothWays(read->network, 300);
    }
}

/// What one file has by its own text.
TEST(RealNetwork, CountsOfMultiIntersections)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "openscenario/esmini/xodr/multi_intersections.xodr");
    const auto read = readNetwork(file);
    ASSERT_TRUE(read) << read.error().message();
    std::size_t elements = 0, signals = 0;
    for (const Road& road : read->network.roads)
    {
        elements += road.referenceLine.elements().size();
        signals += road.signals.size();
    }
    EXPECT_EQ(read->network.roads.size(), 63u);
    EXPECT_EQ(read->network.junctions.size(), 5u);
    EXPECT_GT(elements, 63u);
    EXPECT_GT(signals, 0u);
    for (const Problem& problem : read->problems)
        EXPECT_EQ(problem.kind, ProblemKind::unsupported) << problem.message("");
    const LaneGraph graph(read->network);
    EXPECT_GT(graph.lanes().size(), 60u);
}

TEST(RealNetwork, AWholeCountryIsReadAndCompared)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "xodr/andorra-netconvert.xodr.gz");
    const std::string text = unzipped(file);
    ASSERT_GT(text.size(), 39000000u);
    const auto read = parseNetwork(text, "andorra.xodr");
    ASSERT_TRUE(read) << read.error().message();
    const RoadNetwork& network = read->network;
    EXPECT_EQ(network.roads.size(), 9926u);
    EXPECT_EQ(network.junctions.size(), 1621u);
    for (const Road& road : network.roads)
        EXPECT_EQ(road.isUsable, road.id != "23072" && road.id != "24200") << road.id;
    const auto tooLong = std::count_if(
        read->problems.begin(), read->problems.end(),
        [](const Problem& problem) { return problem.remedy.find("longer than 1e6 m") != std::string::npos; });
    EXPECT_EQ(tooLong, 2);
    const LaneJoints joints = checkLaneJoints(network);
    EXPECT_EQ(joints.count, 13076u);
    const auto gaps = std::count_if(joints.flaws.begin(), joints.flaws.end(),
                                    [](const Flaw& flaw) { return flaw.kind == FlawKind::gap; });
    EXPECT_EQ(gaps, 1007);
    expectBothWays(network, 2000);
}

/// netconvert writes the offset with the other sign: only so the country lies in the Pyrenees.
TEST(RealNetwork, GeoReferenceOfNetconvert)
{
    NetworkHeader header;
    header.geoReference = "+proj=utm +zone=31 +ellps=WGS84 +datum=WGS84 +units=m +no_defs";
    header.offsetX = -370250.79;
    header.offsetY = -4699010.58;
    const auto reference = GeoReference::create(header, "andorra.xodr", true);
    ASSERT_TRUE(reference) << reference.error().message();
    const auto place = reference->toGeodetic({7384.2, 7447.1, 0.0});
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->latitudeDeg, 42.50, 0.02);
    EXPECT_NEAR(place->longitudeDeg, 1.51, 0.02);
}

} // namespace
