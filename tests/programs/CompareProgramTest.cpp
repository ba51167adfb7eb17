// SPDX-License-Identifier: Apache-2.0
// Tests `compare_terrain methods` as it is run: flights, files, what it cannot do, and programs of others.
#include <string>
#include <vector>

#include <osgTerrainROAM/core/method/Method.h>

#include "Playing.h"

namespace
{

using namespace osgTerrainROAM::core;
using nlohmann::ordered_json;
using Keys = std::vector<std::string>;

TEST(CompareProgram, FliesTheComparisonFlightOrAScenario)
{
    const Workplace place;
    const std::string drive = place.write("drive.xosc", driveText("hill.tif"));
    for (const Keys& flight : {Keys{}, Keys{"--flight", drive}})
    {
        Keys arguments{OSGTRAINER_COMPARE_TERRAIN,
                       "methods",
                       place.hill(),
                       "--frames",
                       "6",
                       "--error",
                       "1",
                       "--json",
                       place.path("compared.json"),
                       "--html",
                       place.path("compared.html"),
                       "--markdown",
                       place.path("compared.md")};
        arguments.insert(arguments.end(), flight.begin(), flight.end());
        EXPECT_TRUE(succeeds(runProgram(arguments)));
        const auto json = ordered_json::parse(readBytes(place.path("compared.json")), nullptr, false);
        EXPECT_EQ(json["dems"][0]["dem"], "hill.tif");
        EXPECT_NE(readBytes(place.path("compared.html")).find("hill.tif"), std::string::npos);
        const std::string tables = readBytes(place.path("compared.md"));
        for (const char* heading : {"## Figures", "## Requirements", "## Claims of the paper",
                                    "## Advantages and drawbacks that it lists"})
            EXPECT_NE(tables.find(heading), std::string::npos) << heading;
        EXPECT_EQ(json["dems"][0]["methods"].size(), kMethods.size() + 3);
        for (const ordered_json& method : json["dems"][0]["methods"])
        {
            const auto name = method["name"].get<std::string>();
            EXPECT_EQ(method["frameMs"].is_number(), methodNamed(name).has_value()) << name;
            const std::string picture = readBytes(place.path("compared-pictures/hill-" + name + ".jpg"));
            EXPECT_EQ(picture.substr(0, 2), "\xFF\xD8") << name << ": a JPEG file";
            EXPECT_GT(picture.size(), 5000u) << name << ": with something in it";
        }
    }
}

TEST(CompareProgram, SaysWhatItCannotDo)
{
    const Workplace place;
    EXPECT_TRUE(failsWith(runProgram({OSGTRAINER_COMPARE_TERRAIN, "methods", place.hill(), "--crop", "66"}),
                          1, "compare_terrain", {"square"}));
    EXPECT_TRUE(failsWith(runProgram({OSGTRAINER_COMPARE_TERRAIN, "methods", "none.tif"}), 1,
                          "compare_terrain", {"none.tif"}));
    EXPECT_EQ(runProgram({OSGTRAINER_COMPARE_TERRAIN, "methods", place.hill(), "--error", "0"}).exitCode, 2);
    EXPECT_EQ(
        runProgram({OSGTRAINER_COMPARE_TERRAIN, "methods", place.hill(), "--flight", place.path("no.xosc")})
            .exitCode,
        2);
    EXPECT_TRUE(failsWith(runProgram({OSGTRAINER_COMPARE_TERRAIN, "methods", place.hill(), "--frames", "2",
                                      "--html", place.path("no/a.html")}),
                          1, "compare_terrain", {"no"}));
    const std::string wrong = place.write("wrong.xosc", "<OpenSCENARIO");
    EXPECT_TRUE(
        failsWith(runProgram({OSGTRAINER_COMPARE_TERRAIN, "methods", place.hill(), "--flight", wrong}), 1,
                  "compare_terrain", {"wrong.xosc"}));
}

/// A program that keeps the samples of every 2^k-th column and row, k by the error: what others would be.
const char* const kStandIn = R"(#!/bin/sh
od -An -v -tf4 -w4 "$1" | awk -v n="$2" -v rows="$3" -v error="$4" '
    { heights[NR - 1] = $1 }
    END {
        step = 1; while (step < error && step < 32) step *= 2
        for (r = 0; r < rows; r += step) for (c = 0; c < n; c += step) {
            print "v", c, r, heights[r * n + c]; number[r * n + c] = ++count }
        for (r = 0; r + step < rows; r += step) for (c = 0; c + step < n; c += step) {
            a = number[r * n + c]; b = number[r * n + c + step]
            d = number[(r + step) * n + c]; e = number[(r + step) * n + c + step]
            print "f", a, b, e; print "f", a, e, d } }' > "$5"
)";

/// The row of the stand-in when it is run with that text after it; null: there is none.
ordered_json standInRow(const std::string& more, std::string& said)
{
    const Workplace place;
    const std::string program = place.write("stand-in.sh", kStandIn);
    const std::string command = "run() { sh " + program + " \"$@\"; " + more + "; }; run";
    const ProgramRun run =
        runProgram({OSGTRAINER_COMPARE_TERRAIN, "methods", place.hill(), "--frames", "2", "--error", "4",
                    "--external", "stand-in=" + command, "--json", place.path("compared.json")});
    EXPECT_TRUE(succeeds(run));
    said = run.errors;
    const auto json = ordered_json::parse(readBytes(place.path("compared.json")), nullptr, false);
    for (const ordered_json& method : json["dems"][0]["methods"])
        if (method["name"] == "stand-in")
        {
            ordered_json row = method;
            for (const ordered_json& verdict : json["dems"][0]["requirements"])
                if (verdict["method"] == "stand-in")
                    row[verdict["requirement"].get<std::string>()] = verdict["verdict"];
            return row;
        }
    return nullptr;
}

TEST(CompareProgram, JudgesTheMeshOfAnotherProgramByTheSameError)
{
    std::string said;
    const ordered_json row = standInRow("true", said);
    ASSERT_TRUE(row.is_object()) << said;
    EXPECT_GT(row["trueErrorPx"], 0.4) << "it has few meshes to choose from";
    EXPECT_LT(row["trueErrorPx"], 40.0);
    const int cells = 64;
    bool isOne = false;
    for (int step = 1; step <= 32; step *= 2)
        isOne = isOne || row["triangles"] == 2.0 * (cells / step) * (cells / step);
    EXPECT_TRUE(isOne) << row["triangles"];
    EXPECT_TRUE(row["adaptUsP50"].is_null());
    EXPECT_EQ(row["changedPercent"], 0.0);
    EXPECT_EQ(row["R2"], "met");
    EXPECT_EQ(row["R4"], "not measured");
}

TEST(CompareProgram, FindsHolesInTheMeshOfAnotherProgram)
{
    std::string said;
    const ordered_json row = standInRow("sed -i '$d' \"$5\"", said); // without the last triangle
    ASSERT_TRUE(row.is_object()) << said;
    EXPECT_EQ(row["R2"], "not met");
}

TEST(CompareProgram, HasNoRowOfAProgramThatFailsOrPutsVerticesAnywhere)
{
    std::string said;
    EXPECT_TRUE(standInRow("false", said).is_null());
    EXPECT_NE(said.find("no row of stand-in"), std::string::npos) << said;
    EXPECT_TRUE(standInRow("sed -i 's/^v 0 0 /v 0.5 0 /' \"$5\"", said).is_null());
    EXPECT_NE(said.find("where no sample is"), std::string::npos) << said;
    EXPECT_TRUE(standInRow("rm \"$5\"", said).is_null());
}

} // namespace
