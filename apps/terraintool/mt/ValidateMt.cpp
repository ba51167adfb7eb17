// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <optional>

#include <osgMultiTriangulation/core/check/ForestCheck.h>
#include <osgMultiTriangulation/core/check/StructureCheck.h>
#include <osgMultiTriangulation/core/file/MtFile.h>

#include "terraintool/mt/MtRequest.h"

namespace terraintool
{

namespace
{

using namespace osgMultiTriangulation::core;

/// The trees of a file that are whole, renumbered, and what is wrong with the others.
struct WholeTrees
{
    Forest forest;
    std::vector<std::string> faults;
};

WholeTrees readWhole(const MtFile& file)
{
    WholeTrees whole;
    std::vector<std::optional<ReadTree>> read(file.info().trees.size());
    std::vector<std::uint32_t> numbers(read.size(), kNone);
    for (std::uint32_t t = 0; t < read.size(); ++t)
    {
        const std::uint32_t parent = file.info().trees[t].parent;
        if (parent != kNone && !read[parent])
        {
            whole.faults.push_back("tree " + std::to_string(t) + " hangs below a damaged one");
            continue;
        }
        auto tree = file.read(t, parent == kNone ? nullptr : &*read[parent]);
        if (!tree)
        {
            whole.faults.push_back(tree.error().what);
            continue;
        }
        read[t] = std::move(*tree);
        numbers[t] = static_cast<std::uint32_t>(whole.forest.trees.size());
        ForestTree own = read[t]->tree;
        if (parent != kNone) own.parent = numbers[parent];
        whole.forest.trees.push_back(std::move(own));
    }
    return whole;
}

nlohmann::ordered_json findingsOf(const MtFile& file, int frames, bool& isSound)
{
    nlohmann::ordered_json row;
    row["file"] = file.path().string();
    WholeTrees whole = readWhole(file);
    row["points"] = file.info().points;
    row["trees"] = file.info().trees.size();
    row["wholeTrees"] = whole.forest.trees.size();
    if (const auto fault = checkStructure(whole.forest); fault && !whole.forest.trees.empty())
        whole.faults.push_back(*fault);
    if (!whole.forest.trees.empty())
    {
        const std::size_t points = pointsOf(whole.forest).size();
        if (whole.faults.empty() && points != file.info().points)
            whole.faults.push_back("the trees have " + std::to_string(points) + " points");
        const ForestFlight flight = flyOver(whole.forest, frames);
        row["frames"] = flight.frames;
        row["measuredFrames"] = flight.checkedFrames;
        row["mostTriangles"] = flight.mostTriangles;
        row["worstExcessM"] = flight.worstExcessM;
        if (flight.fault) whole.faults.push_back(*flight.fault);
    }
    isSound = whole.faults.empty();
    row["faults"] = whole.faults;
    return row;
}

} // namespace

void validateMt(const std::filesystem::path& path, int frames, terminal::Report& report)
{
    bool isSound = false;
    nlohmann::ordered_json row;
    if (const auto file = MtFile::open(path))
        row = findingsOf(*file, frames, isSound);
    else
        row = {{"file", path.string()}, {"faults", {file.error().what}}};
    report.sound = report.sound && isSound;
    std::cout << (isSound ? "sound  " : "BROKEN ") << path.string();
    if (row.contains("frames"))
        std::cout << ": " << row["wholeTrees"] << " of " << row["trees"] << " trees, " << row["frames"]
                  << " frames, at most " << row["mostTriangles"] << " triangles";
    std::cout << '\n';
    for (const auto& fault : row["faults"])
        std::cout << "  " << fault.get<std::string>() << '\n';
    report.json["files"].push_back(std::move(row));
}

} // namespace terraintool
