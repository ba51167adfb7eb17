// SPDX-License-Identifier: Apache-2.0
#include "Kinds.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "PmCheckSums.h"

namespace
{

namespace fs = std::filesystem;
using Command = std::vector<std::string>;

fs::path written(const fs::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

/// A hill of 33² samples as an ESRI ASCII grid.
std::string hillGrid()
{
    std::ostringstream text;
    text << "ncols 33\nnrows 33\nxllcorner 0\nyllcorner 0\ncellsize 30\nNODATA_value -9999\n";
    for (int row = 0; row < 33; ++row)
        for (int column = 0; column < 33; ++column)
            text << (row * (32 - row) + column * (32 - column)) / 4 << (column == 32 ? '\n' : ' ');
    return text.str();
}

/// A grid of 12² squares over a wave, with texture coordinates.
std::string wavesModel()
{
    std::ostringstream text;
    for (int y = 0; y <= 12; ++y)
        for (int x = 0; x <= 12; ++x)
            text << "v " << x << ' ' << y << ' ' << 0.125 * ((x * y) % 7) << "\nvt " << x / 12.0 << ' '
                 << y / 12.0 << '\n';
    for (int y = 0; y < 12; ++y)
        for (int x = 1; x <= 12; ++x)
        {
            const int corners[] = {13 * y + x, 13 * y + x + 1, 13 * y + x + 14, 13 * y + x + 13};
            text << 'f';
            for (const int c : corners)
                text << ' ' << c << '/' << c;
            text << '\n';
        }
    return text.str();
}

/// Returns files of real data with one of the extensions, up to 4 MB.
std::vector<fs::path> realFiles(const fs::path& folder, std::initializer_list<const char*> extensions)
{
    std::vector<fs::path> files;
    std::error_code none;
    if (folder.empty() || !fs::is_directory(folder, none)) return files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none))
        if (entry.is_regular_file() && entry.file_size() < (4u << 20) &&
            std::any_of(extensions.begin(), extensions.end(),
                        [&](const char* extension) { return entry.path().extension() == extension; }))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<fs::path> joined(std::vector<fs::path> files, const std::vector<fs::path>& more)
{
    files.insert(files.end(), more.begin(), more.end());
    return files;
}

/// Makes the kinds; holds what their commands share.
class KindMaker
{
public:
    explicit KindMaker(const MutantFolders& folders)
        : _folders(folders),
          _pmtool((folders.programs / "pmtool").string()),
          _terraintool((folders.programs / "terraintool").string()),
          _trainer((folders.programs / "trainer").string()),
          _roadtool((folders.programs / "roadtool").string()),
          _hill(written(folders.scratch / "hill.asc", hillGrid()).string())
    {
    }

    std::vector<InputKind> all() const
    {
        const fs::path waves = written(_folders.scratch / "waves.obj", wavesModel());
        const fs::path corpus = _folders.source / "tests/fuzz/corpus";
        const fs::path view = written(_folders.scratch / "view.xml",
                                      "<View layout=\"tiled\">\n  <Channel name=\"a\" widthPx=\"64\" "
                                      "heightPx=\"36\" fovXDeg=\"60\" yawDeg=\"-30\"/>\n"
                                      "  <Channel name=\"b\" widthPx=\"64\" heightPx=\"36\"><Frustum "
                                      "leftDeg=\"-20\" rightDeg=\"35\" bottomDeg=\"-15\" "
                                      "topDeg=\"25\"/></Channel>\n</View>\n");
        const fs::path roam = written(_folders.scratch / "hill.roam", "dem = hill.asc\n");
        const fs::path scenery = written(
            _folders.scratch / "scenery.json",
            R"({"seed": 3, "fields": [{"name": "a", "arrangement": "scattered", "count": 4, "objects": [{"kind": "barn"}],
 "where": {"circle": {"eastM": 400, "northM": 400, "radiusM": 300}}}]})");
        const fs::path models = _folders.realData.empty() ? "" : _folders.realData / "models";
        const fs::path dems = _folders.realData.empty() ? "" : _folders.realData / "dem";
        const fs::path scenarioData = _folders.realData.empty() ? "" : _folders.realData / "openscenario";
        return {modelsOf("obj", joined({waves}, realFiles(models, {".obj"}))),
                modelsOf("ac", realFiles(models, {".ac"})),
                modelsOf("glb", joined({corpus / "quad.glb"}, realFiles(models, {".glb"}))),
                modelsOf("gltf", {corpus / "quad.gltf"}),
                progressiveMeshes({corpus / "waves.pm", corpus / "quantised.pm", corpus / "images.pm"}),
                terrains("dem",
                         joined({_hill}, realFiles(dems, {".asc", ".tif", ".hgt", ".dt0", ".gz", ".zip"}))),
                terrains("roam", {roam}),
                of("scenery", {scenery}, "--scenery"),
                of("view", {view}, "--view"),
                scenarios({_folders.source / "data/scenarios/drive.xosc", corpus / "story.xosc",
                           corpus / "speed.xosc"}),
                roads(joined({corpus / "curves.xodr", corpus / "junction.xodr"},
                             realFiles(scenarioData, {".xodr"}))),
                aircraft({_folders.source / "data/aircraft/c172p.xml"}),
                roadVehicles(
                    {_folders.source / "data/vehicles/car.xml", _folders.source / "data/vehicles/van.xml"}),
                polygons({corpus / "faces.obj", corpus / "frame.geojson"})};
    }

private:
    InputKind modelsOf(const std::string& name, std::vector<fs::path> seeds) const
    {
        const std::string output = (_folders.scratch / "made.pm").string();
        return {name, std::move(seeds),
                [pmtool = _pmtool, output](const std::string& file) -> std::vector<Command>
                {
                    return {{pmtool, "info", file},
                            {pmtool, "consolidate", file},
                            {pmtool, "simplify", file, "--targets", "20"},
                            {pmtool, "build", file, "-o", output}};
                }};
    }

    InputKind progressiveMeshes(std::vector<fs::path> seeds) const
    {
        InputKind kind = modelsOf("pm", std::move(seeds));
        kind.repair = testsupport::renewCheckSums;
        return kind;
    }

    InputKind terrains(const std::string& name, std::vector<fs::path> seeds) const
    {
        return {name, std::move(seeds), [this_ = *this](const std::string& file) -> std::vector<Command> {
                    return {{this_._terraintool, "info", file}, this_.tour(file, {})};
                }};
    }

    InputKind of(const std::string& name, std::vector<fs::path> seeds, const std::string& option) const
    {
        return {name, std::move(seeds),
                [this_ = *this, option](const std::string& file) -> std::vector<Command> {
                    return {this_.tour(this_._hill, {option, file})};
                }};
    }

    InputKind scenarios(std::vector<fs::path> seeds) const
    {
        return {"xosc", std::move(seeds),
                [this_ = *this](const std::string& file) -> std::vector<Command>
                {
                    return {{this_._trainer, "check", file},
                            {this_._trainer, "play", file, "--terrain", this_._hill, "--size", "64x36",
                             "--frames", "1"}};
                }};
    }

    InputKind roads(std::vector<fs::path> seeds) const
    {
        const std::string svg = (_folders.scratch / "roads.svg").string(),
                          png = (_folders.scratch / "roads.png").string();
        return {"xodr", std::move(seeds),
                [roadtool = _roadtool, svg, png](const std::string& file) -> std::vector<Command>
                {
                    return {{roadtool, "info", file},
                            {roadtool, "validate", file},
                            {roadtool, "draw", file, "--svg", svg, "--png", png, "--pixels", "200"}};
                }};
    }

    InputKind aircraft(std::vector<fs::path> seeds) const
    {
        return {"aircraft", std::move(seeds),
                [trainer = _trainer](const std::string& file) -> std::vector<Command> {
                    return {{trainer, "qualify", "flight", "--aircraft", file}};
                }};
    }

    InputKind roadVehicles(std::vector<fs::path> seeds) const
    {
        return {"vehicle", std::move(seeds),
                [trainer = _trainer](const std::string& file) -> std::vector<Command> {
                    return {{trainer, "qualify", "drive", "--stand", "10", "--vehicle", file}};
                }};
    }

    InputKind polygons(std::vector<fs::path> seeds) const
    {
        const std::string output = (_folders.scratch / "tessellated").string();
        return {"polygons", std::move(seeds),
                [pmtool = _pmtool, output](const std::string& file) -> std::vector<Command> {
                    return {{pmtool, "tessellate", file, "--output", output}};
                }};
    }

    Command tour(const std::string& terrain, const Command& more) const
    {
        Command command = {_trainer, "tour", terrain, "--size", "64x36", "--frames", "1"};
        command.insert(command.end(), more.begin(), more.end());
        return command;
    }

    MutantFolders _folders;
    std::string _pmtool, _terraintool, _trainer, _roadtool, _hill;
};

} // namespace

std::vector<InputKind> inputKinds(const MutantFolders& folders)
{
    return KindMaker(folders).all();
}
