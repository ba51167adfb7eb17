// SPDX-License-Identifier: Apache-2.0
// `pmtool consolidate --quad-diagonal` as somebody runs it.
#include <sstream>

#include "PmToolRun.h"

namespace
{

/// A valley side with a crease: heights 0 and 3 across from one another, 1 and 1 on the other diagonal; a
/// bow-tie; a triangle. OpenSceneGraph reads .obj with y up: (x, y, z) becomes (x, -z, y).
constexpr const char* kQuads = "v 0 0 0\nv 1 1 0\nv 1 3 -1\nv 0 1 -1\nv 5 0 0\nv 6 0 -1\nv 6 0 0\nv 5 0 -1\n"
                               "f 1 2 3 4\nf 5 6 7 8\nf 5 7 6\n";

/// Whether a face of a plain .obj has both vertices.
bool hasEdge(const std::string& obj, const std::string& a, const std::string& b)
{
    std::istringstream lines(obj);
    for (std::string line; std::getline(lines, line);)
        if (line[0] == 'f' && (line + ' ').find(' ' + a + ' ') != line.npos &&
            (line + ' ').find(' ' + b + ' ') != line.npos)
            return true;
    return false;
}

/// The plain .obj of what was read, before it is repaired; vertices may be numbered anew, so they are found
/// by their positions.
std::string diagonalBy(const Workplace& place, const std::string& rule)
{
    const std::string file = place.write("quads.obj", kQuads), folder = place.path(rule);
    const auto row =
        pmToolTable(place, {"consolidate", file, "--quad-diagonal", rule, "--dump", folder})["models"][0];
    EXPECT_EQ(row["quads"]["cut"], 1) << rule;
    EXPECT_EQ(row["quads"]["left"], 1) << rule;
    const std::string obj = readBytes(folder + "/quads.before.obj");
    std::istringstream lines(obj);
    std::string low, high;
    int vertex = 0;
    for (std::string line; std::getline(lines, line);)
    {
        if (line[0] == 'v') ++vertex;
        if (line == "v 0 0 0") low = std::to_string(vertex);
        if (line == "v 1 1 3") high = std::to_string(vertex);
    }
    return hasEdge(obj, low, high) ? "steep" : "level";
}

TEST(PmToolQuads, AreCutAsTheRuleSays)
{
    const Workplace place;
    EXPECT_EQ(diagonalBy(place, "heights"), "level");
    EXPECT_EQ(diagonalBy(place, "height-difference"), "steep");
    for (const char* rule : {"colours", "normals", "angle", "areas"})
        diagonalBy(place, rule);
}

TEST(PmToolQuads, AreNotCountedWithoutARule)
{
    const Workplace place;
    const std::string file = place.write("quads.obj", kQuads);
    EXPECT_FALSE(pmToolTable(place, {"consolidate", file})["models"][0].contains("quads"));
    EXPECT_TRUE(failsWith(runPmTool({"consolidate", file, "--quad-diagonal", "longest"}), 2, "pmtool",
                          {"--quad-diagonal"}));
}

} // namespace
