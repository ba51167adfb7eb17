// SPDX-License-Identifier: Apache-2.0
// What makes `terraintool validate` end with exit code 1. No file makes the engine draw a broken mesh, so
// meshes are broken here, and the command is exchanged for one that finds them.
#include "terraintool/FlightFindings.h"

#include <limits>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "RasterWriter.h"
#include "SyntheticField.h"
#include "terminal/Terminal.h"
#include "terraintool/RunCommand.h"

namespace
{

using namespace osgTerrainROAM::core;
using namespace terraintool;

/// A mesh from above, as the flight's checks see it.
struct Frame
{
    Frame() : tile(testsupport::planarTile(testsupport::hills(33, 33))), mesh(tile)
    {
        said = mesh.refine(20.0);
        said.tolerancePx = 1.0;
        drawn = mesh.drawn();
    }

    FlightFindings findings() const
    {
        FlightFindings flight;
        DrawnMeshReport report = checkDrawnMesh(*tile, drawn, nullptr);
        report.maxErrorPx = errorPx;
        flight.add(report, said, {.errorTolerancePx = 1.0, .maxTriangles = ceiling});
        return flight;
    }

    std::shared_ptr<const RoamTile> tile;
    RoamMesh mesh;
    RefineResult said;
    DrawnMesh drawn;
    double errorPx = 0.7;
    std::uint32_t ceiling = 200000;
};

TEST(FlightFindings, OfASoundMeshAreSound)
{
    const FlightFindings flight = Frame().findings();
    EXPECT_TRUE(flight.isSound()) << flight.text();
    EXPECT_EQ(flight.frames, 1U);
    EXPECT_EQ(flight.maxErrorPx, 0.7);
    EXPECT_EQ(flight.tolerancePx, 1.0);
}

TEST(FlightFindings, ATriangleThatIsMissingIsNotSound)
{
    Frame frame;
    frame.drawn.triangles.erase(frame.drawn.triangles.begin() + 5);
    EXPECT_FALSE(frame.findings().isSound());
    EXPECT_GT(frame.findings().tJunctions, 0U);
}

TEST(FlightFindings, AVertexOffItsPlaceIsNotSound)
{
    Frame frame;
    frame.drawn.vertices[frame.drawn.triangles[7].vertices[0]].position.z +=
        static_cast<int>(0.01 / frame.drawn.stepM);
    EXPECT_FALSE(frame.findings().isSound());
    EXPECT_GT(frame.findings().cracks, 0U);
}

TEST(FlightFindings, MoreTrianglesThanTheCeilingAreNotSound)
{
    Frame frame;
    frame.ceiling = frame.said.leaves;
    EXPECT_TRUE(frame.findings().isSound());
    frame.ceiling = frame.said.leaves - 1;
    EXPECT_FALSE(frame.findings().isSound());
    EXPECT_EQ(frame.findings().ceilingExceeded, 1U);
}

TEST(FlightFindings, AnErrorBeyondTheToleranceIsNotSound)
{
    Frame frame;
    frame.errorPx = 1.0;
    EXPECT_TRUE(frame.findings().isSound());
    for (const double errorPx : {1.0 + 1e-9, std::numeric_limits<double>::quiet_NaN()})
    {
        frame.errorPx = errorPx;
        EXPECT_FALSE(frame.findings().isSound());
        EXPECT_NE(frame.findings().text().find("1 beyond their tolerance"), std::string::npos)
            << frame.findings().text();
    }
}

TEST(FlightFindings, OneBadFrameSpoilsTheFlight)
{
    FlightFindings flight;
    flight.add({.tJunctions = 0, .cracks = 0, .maxErrorPx = 0.5}, {.tolerancePx = 1.0}, {});
    flight.add({.tJunctions = 0, .cracks = 1, .maxErrorPx = 0.2}, {.tolerancePx = 1.0}, {});
    flight.add({.tJunctions = 0, .cracks = 0, .maxErrorPx = 0.4}, {.tolerancePx = 1.0}, {});
    EXPECT_FALSE(flight.isSound());
    EXPECT_EQ(flight.frames, 3U);
    EXPECT_EQ(flight.maxErrorPx, 0.5);
}

/// A command that finds what it is told.
Command finding(bool sound)
{
    return [sound](const Request&) -> foundation::Result<Report>
    {
        Report report;
        report.sound = sound;
        report.json["files"].push_back({{"file", "a.tif"}, {"cracks", sound ? 0 : 1}});
        return report;
    };
}

TEST(RunCommand, ExitsWithOneWhenAnythingIsOffAndStillLeavesTheTable)
{
    const TemporaryFolder folder;
    EXPECT_EQ(run(finding(true), {}, folder / "sound.json"), terminal::kDone);
    EXPECT_EQ(run(finding(false), {}, folder / "off.json"), terminal::kFailed);
    EXPECT_EQ(nlohmann::json::parse(readBytes(folder / "off.json"))["files"][0]["cracks"], 1);
    EXPECT_EQ(run(finding(false), {}, {}), terminal::kFailed);
}

TEST(RunCommand, ExitsWithOneAfterAnErrorAndLeavesNoTable)
{
    const TemporaryFolder folder;
    const Command failing = [](const Request&) -> foundation::Result<Report> {
        return foundation::Error{"a", "b", "c"};
    };
    EXPECT_EQ(run(failing, {}, folder / "table.json"), terminal::kFailed);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

} // namespace
