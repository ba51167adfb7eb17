// SPDX-License-Identifier: Apache-2.0
#include "Playing.h"

#include <algorithm>
#include <set>

#include <osgOffscreen/PngFile>

namespace
{

void addUnlessGiven(std::vector<std::string>& arguments, const std::string& option, const std::string& value)
{
    if (std::find(arguments.begin(), arguments.end(), option) != arguments.end()) return;
    arguments.insert(arguments.end(), {option, value});
}

} // namespace

Playing playedAs(const Workplace& place, const std::string& name, const std::vector<std::string>& command,
                 const std::vector<std::string>& more)
{
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), more.begin(), more.end());
    addUnlessGiven(arguments, "--size", "96x54");
    addUnlessGiven(arguments, "--frames", "4");
    addUnlessGiven(arguments, "--capture", place.path(name));
    addUnlessGiven(arguments, "--stats", place.path(name + ".json"));
    EXPECT_TRUE(succeeds(runTrainer(arguments)));
    Playing playing;
    playing.frames = bytesIn(place.path(name));
    playing.statistics = nlohmann::json::parse(readBytes(place.path(name + ".json")), nullptr, false);
    return playing;
}

std::map<std::string, std::string> bytesIn(const std::filesystem::path& folder)
{
    std::map<std::string, std::string> files;
    std::error_code failed;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, failed))
        if (entry.is_regular_file())
            files[std::filesystem::relative(entry.path(), folder).string()] = readBytes(entry.path());
    EXPECT_FALSE(failed) << folder << ": " << failed.message();
    return files;
}

nlohmann::json withoutMeasured(nlohmann::json statistics)
{
    const auto strip = [](nlohmann::json& row)
    {
        for (const char* measured : {"adaptUs", "cullMs", "drawMs", "wallMs", "processorMs", "residentMb"})
            EXPECT_EQ(row.erase(measured), 1U) << measured;
        row.erase("objectCullMs"); // there with a scenery alone
    };
    for (nlohmann::json& frame : statistics.at("frames"))
        strip(frame);
    strip(statistics.at("summary"));
    EXPECT_EQ(statistics.erase("opening"), 1U);
    return statistics;
}

PictureFacts factsOf(const std::filesystem::path& png)
{
    const auto picture = osgOffscreen::readPng(png);
    if (!picture)
    {
        ADD_FAILURE() << picture.error().message();
        return {};
    }
    const osg::Image& image = **picture;
    std::set<unsigned> colours;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
        {
            const unsigned char* rgb = image.data(x, y);
            colours.insert(rgb[0] | rgb[1] << 8U | rgb[2] << 16U);
        }
    return {image.s(), image.t(), colours.size()};
}

std::size_t hashOf(const std::filesystem::path& file)
{
    return std::hash<std::string>()(readBytes(file));
}

std::vector<std::string> keysOf(const nlohmann::ordered_json& object)
{
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items())
        keys.push_back(key);
    return keys;
}
