// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "Kinds.h"
#include "Seeds.h"

namespace
{

const char* const kInputs = R"(osgtrainer-inputs 1
ramped
columns time throttle brake steering
0 0 0 0
1 1 0 0.1
2 0 1 -
end 3
)";

const char* const kTrack = R"(time,latitude,longitude,altitude
0,46.5000,8.0000,500
1,46.5005,8.0002,510
2,46.5010,8.0005,520
3,46.5015,8.0009,530
)";

InputKind scenarios(const MutantFolders& folders, seeds::Files files)
{
    return {"xosc", std::move(files),
            [folders](const std::string& file) -> std::vector<Command>
            {
                return {folders.command("trainer", {"check", file}),
                        folders.command("trainer", {"play", file, "--terrain", folders.made("hill.asc"),
                                                    "--size", "64x36", "--frames", "1"})};
            }};
}

/// Files that one command of the trainer reads, as the last word.
InputKind ofTrainer(const MutantFolders& folders, const std::string& name, seeds::Files files, Command words)
{
    return {name, std::move(files),
            [folders, words = std::move(words)](const std::string& file) -> std::vector<Command>
            {
                Command all = words;
                all.push_back(file);
                return {folders.command("trainer", std::move(all))};
            }};
}

seeds::Files vehicleFiles(const MutantFolders& folders)
{
    return {folders.source / "data/vehicles/car.xml", folders.source / "data/vehicles/van.xml"};
}

} // namespace

std::vector<InputKind> rideKinds(const MutantFolders& folders)
{
    using seeds::joined, seeds::realFiles, seeds::written;
    const auto corpus = folders.corpus();
    const auto tracks = folders.real("tracks");
    const std::string road = (corpus / "curves.xodr").string();
    const auto named = [&](const char* name, const char* text) -> seeds::Files
    { return {written(folders.scratch / name, text)}; };
    return {
        scenarios(folders, {folders.source / "data/scenarios/drive.xosc", corpus / "story.xosc",
                            corpus / "speed.xosc"}),
        ofTrainer(
            folders, "tracks",
            joined(named("track.csv", kTrack), realFiles(tracks, {".gpx", ".igc", ".kml", ".acmi", ".gz"})),
            {"play", "--size", "64x36", "--frames", "1"}),
        ofTrainer(folders, "foreign-tracks",
                  {corpus / "track.csv", corpus / "attitude.csv", corpus / "yaw.csv", corpus / "track.gpx",
                   corpus / "track.kml", corpus / "track.kmz", corpus / "flight.igc", corpus / "flight.acmi"},
                  {"play", "--headless"}),
        ofTrainer(folders, "aircraft", {folders.source / "data/aircraft/c172p.xml"},
                  {"qualify", "flight", "--aircraft"}),
        ofTrainer(folders, "vehicle", vehicleFiles(folders),
                  {"qualify", "drive", "--stand", "10", "--vehicle"}),
        ofTrainer(folders, "inputs", named("ride.inputs", kInputs),
                  {"drive", road, "--headless", "--duration", "5", "--inputs"}),
        ofTrainer(folders, "keys", {corpus / "ride.keys"},
                  {"drive", road, "--window", "--duration", "1", "--keys"}),
        ofTrainer(folders, "devices", {corpus / "wheel.devices"}, {"devices", "--devices"})};
}
