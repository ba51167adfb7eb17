// SPDX-License-Identifier: Apache-2.0
// `compare_objects order` with the arguments of the command line, in this process.
#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "OrderMeshes.h"
#include "RealData.h"
#include "TestFolder.h"
#include "compare/objects/Commands.h"
#include "compare/objects/OrderRow.h"
#include "terminal/CommandLine.h"

namespace
{

using nlohmann::ordered_json;
using osgPMObjects::core::Triangle;

class Folder : public testsupport::TestFolder
{
public:
    Folder() : TestFolder("compare-order") {}
};

foundation::Result<terminal::Report> compareOrder(const std::vector<std::string>& arguments)
{
    CLI::App app;
    pmtool::Chosen chosen;
    pmtool::addCompareOrder(app, chosen);
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    reversed.emplace_back("order");
    app.parse(reversed);
    return chosen.work();
}

std::vector<Triangle> readDump(const std::filesystem::path& file)
{
    const std::string bytes = testsupport::bytesOf(file);
    std::vector<Triangle> triangles(bytes.size() / 12);
    for (std::size_t i = 0; i < triangles.size() * 3; ++i)
        for (int k = 3; k >= 0; --k)
            triangles[i / 3][i % 3] =
                triangles[i / 3][i % 3] << 8 | static_cast<std::uint8_t>(bytes[4 * i + k]);
    return triangles;
}

/// Counts transformed vertices with the given queue, which is emptied for each draw call.
double fifoOf(const std::vector<Triangle>& triangles, const ordered_json& calls, std::size_t size)
{
    std::size_t misses = 0, next = 0;
    for (const ordered_json& call : calls)
    {
        std::deque<std::uint32_t> queue;
        for (const std::size_t end = next + call["triangles"].get<std::size_t>(); next < end; ++next)
            for (const std::uint32_t vertex : triangles[next])
            {
                if (std::find(queue.begin(), queue.end(), vertex) != queue.end()) continue;
                ++misses;
                queue.push_back(vertex);
                if (queue.size() > size) queue.pop_front();
            }
    }
    return static_cast<double>(misses) / static_cast<double>(triangles.size());
}

/// Checks that each draw call has the same faces with the same front sides.
bool showsTheSame(const std::vector<Triangle>& a, const std::vector<Triangle>& b, const ordered_json& calls)
{
    std::size_t next = 0;
    for (const ordered_json& call : calls)
    {
        const auto part = [&](const std::vector<Triangle>& all)
        {
            const auto first = all.begin() + static_cast<std::ptrdiff_t>(next);
            return testsupport::orientedSet({first, first + call["triangles"].get<std::ptrdiff_t>()});
        };
        if (part(a) != part(b)) return false;
        next += call["triangles"].get<std::size_t>();
    }
    return a.size() == b.size() && next == a.size();
}

double transforms(const ordered_json& mesh, const std::string& order, const std::string& cache)
{
    for (const ordered_json& row : mesh["orders"])
        if (row["order"] == order) return row["transformsPerTriangle"][cache].get<double>();
    return -1.0;
}

constexpr const char* kTwoMaterials = "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nv 1 2 0\n"
                                      "usemtl red\nf 1 2 3 4\nusemtl blue\nf 4 3 6 5\n";

TEST(CompareOrder, DrawsEachMaterialByACallOfItsOwn)
{
    const Folder folder;
    folder.write("two.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    const auto report = compareOrder({folder.write("two.obj", kTwoMaterials).string()});
    ASSERT_TRUE(report);
    const ordered_json& model = report->json["models"][0];
    EXPECT_EQ(model["triangles"], 4);
    EXPECT_EQ(model["meshes"][0]["vertices"], "positions");
    EXPECT_EQ(model["meshes"][0]["drawCalls"].size(), 1u);
    EXPECT_EQ(transforms(model["meshes"][0], "meshoptimizer", "fifo10"), 6.0 / 4.0);
    EXPECT_EQ(model["meshes"][1]["vertices"], "wedges");
    EXPECT_EQ(model["meshes"][1]["drawCalls"].size(), 2u);
    EXPECT_EQ(transforms(model["meshes"][1], "meshoptimizer", "fifo10"), 8.0 / 4.0);
    EXPECT_EQ(model["meshes"][0]["orders"].size(), pmtool::orderNames().size());
}

TEST(CompareOrder, DumpsWhatItCounts)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(model, "models/aircraft/KC-130.ac");
    const Folder folder;
    const auto report = compareOrder({model.string(), "--dump", (folder / "dump").string()});
    ASSERT_TRUE(report);
    for (const ordered_json& mesh : report->json["models"][0]["meshes"])
    {
        const ordered_json& calls = mesh["drawCalls"];
        const auto given = readDump(folder / "dump" / mesh["orders"][0]["dump"].get<std::string>());
        ASSERT_EQ(given.size(), report->json["models"][0]["triangles"]);
        for (const ordered_json& row : mesh["orders"])
        {
            auto dumped = readDump(folder / "dump" / row["dump"].get<std::string>());
            ASSERT_TRUE(showsTheSame(dumped, given, calls)) << row["order"];
            for (const std::size_t size : {10u, 16u, 32u})
                EXPECT_EQ(row["transformsPerTriangle"]["fifo" + std::to_string(size)].get<double>(),
                          fifoOf(dumped, calls, size))
                    << row["order"];
            std::swap(dumped[7][0], dumped[7][1]); // the mutation
            EXPECT_FALSE(showsTheSame(dumped, given, calls));
        }
    }
}

TEST(CompareOrder, OfRealModelsHoldsWhatTheTableSays)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(models, "models");
    std::vector<std::string> files;
    for (const char* file : {"vehicle/Forklift.ac", "aircraft/KC-130.ac", "aircraft/cessna.obj",
                             "ship/vinson.ac", "character/pirate.obj", "cad/club.obj"})
        files.push_back((models / file).string());
    const auto report = compareOrder(files);
    ASSERT_TRUE(report);
    for (const ordered_json& model : report->json["models"])
    {
        const ordered_json& mesh = model["meshes"][0];
        const auto of = [&](const std::string& order, const std::string& cache)
        { return transforms(mesh, order, cache); };
        for (const std::string cache : {"fifo10", "fifo16", "fifo32"})
        { // a universal order is better than strips for caches of more than ten vertices
            const double strips =
                std::min({of("sgiStrips", cache), of("dualGraphStrips", cache), of("fifoStrips16", cache)});
            EXPECT_LT(of("universal", cache), strips) << model["model"] << " " << cache;
        }
        EXPECT_GT(of("universal", "fifo4"), of("dualGraphStrips", "fifo4"))
            << model["model"]; // and not for small ones
        EXPECT_LT(of("universal", "fifo32"), 1.13 * of("meshoptimizer", "fifo32")) << model["model"];
        EXPECT_LT(of("locality16", "fifo16"), 1.12 * of("meshoptimizer", "fifo16")) << model["model"];
        EXPECT_GT(of("random", "fifo16"), 2.0 * of("meshoptimizer", "fifo16")) << model["model"];
    }
}

TEST(CompareOrder, GoesOnAfterWhatIsNoModel)
{
    const Folder folder;
    testing::internal::CaptureStderr();
    const auto report =
        compareOrder({(folder / "none.obj").string(), folder.write("words.txt", "no model").string(),
                      folder.write("points.obj", "v 0 0 0\nv 1 0 0\n").string(),
                      folder.write("two.obj", kTwoMaterials).string()});
    const std::string errors = testing::internal::GetCapturedStderr();
    ASSERT_TRUE(report);
    EXPECT_FALSE(report->sound);
    EXPECT_EQ(report->json["models"].size(), 1u);
    for (const char* file : {"none.obj: ", "words.txt: ", "points.obj: "})
        EXPECT_THAT(errors, testing::HasSubstr(file));
}

TEST(CompareOrder, RefusesAFolderThatCannotBe)
{
    const Folder folder;
    const auto blocked = compareOrder(
        {folder.write("two.obj", kTwoMaterials).string(), "--dump", folder.write("file", "").string()});
    ASSERT_FALSE(blocked);
    EXPECT_THAT(blocked.error().message(), testing::HasSubstr("file"));
}

} // namespace
