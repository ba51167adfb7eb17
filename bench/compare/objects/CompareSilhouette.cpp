// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include <foundation/WholeFile.h>

#include <osg/Image>
#include <osgDB/Registry>

#include <osgPMObjects/core/polish/ImageMeter.h>

#include <osgPMObjects/MaterialLooks>

#include "compare/objects/CheckerCoordinates.h"
#include "compare/objects/Commands.h"
#include "compare/objects/SimplifyTool.h"
#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "terminal/CommandLine.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

struct SilhouetteRequest
{
    ModelRequest models;
    std::vector<std::string> tools{"optimal"};
    std::vector<double> targetPercents{5.0, 1.0};
    core::ImageMeterSettings images;
    bool checker = false;
    std::filesystem::path imageFolder;
};

/// The views that an image file shows side by side, as shares of all views from above to below.
constexpr double kShownViews[] = {0.2, 0.4, 0.5, 0.8};

/// A look with squares of two shades, as large as a 32th of the texture, for every material.
std::vector<core::MaterialLook> checkerLooks(std::size_t materials)
{
    constexpr std::uint32_t kTexels = 64;
    core::MaterialLook look{.texels = {}, .texelsWide = kTexels, .texelsHigh = kTexels};
    for (std::uint32_t y = 0; y < kTexels; ++y)
        for (std::uint32_t x = 0; x < kTexels; ++x)
            look.texels.push_back((x / 2 + y / 2) % 2 == 0 ? 255 : 115);
    return std::vector<core::MaterialLook>(materials, look);
}

/// Images of the original and its levels, one below the other.
class ImageRows
{
public:
    explicit ImageRows(const core::ImageMeter& meter) : _meter(meter) {}

    void add(const core::Mesh& mesh)
    {
        const auto side = static_cast<std::size_t>(_meter.settings().sizePx);
        std::vector<std::uint8_t> row(side * width());
        for (std::size_t i = 0; i < std::size(kShownViews); ++i)
        {
            const auto view = static_cast<int>(kShownViews[i] * _meter.settings().views);
            const std::vector<std::uint8_t> image = _meter.image(mesh, view);
            for (std::size_t y = 0; y < side; ++y)
                std::memcpy(&row[y * width() + i * side], &image[y * side], side);
        }
        _bytes.insert(_bytes.begin(), row.begin(), row.end()); // rows of OSG's images come from below
    }

    /// Writes them as PNG. Errors: OpenSceneGraph's plug-in is missing; the file cannot be written.
    foundation::Outcome write(const std::filesystem::path& file)
    {
        const osg::ref_ptr<osgDB::ReaderWriter> writer =
            osgDB::Registry::instance()->getReaderWriterForExtension("png");
        if (!writer)
            return foundation::Error{file.string(), "OpenSceneGraph has no plug-in for PNG",
                                     "install its plug-ins, or leave --images out"};
        const osg::ref_ptr<osg::Image> image = new osg::Image;
        image->setImage(static_cast<int>(width()), static_cast<int>(_bytes.size() / width()), 1, GL_LUMINANCE,
                        GL_LUMINANCE, GL_UNSIGNED_BYTE, _bytes.data(), osg::Image::NO_DELETE);
        std::ostringstream stream;
        if (const auto written = writer->writeImage(*image, stream); !written.success())
            return foundation::Error{file.string(), "was not written: " + written.message(),
                                     "leave --images out"};
        return foundation::writeWholeFile(file, stream.str());
    }

private:
    std::size_t width() const
    {
        return std::size(kShownViews) * static_cast<std::size_t>(_meter.settings().sizePx);
    }

    const core::ImageMeter& _meter;
    std::vector<std::uint8_t> _bytes;
};

void printSilhouetteRow(const Json& row)
{
    std::cout << "  " << std::left << std::setw(14) << row["tool"].get<std::string>() << std::right
              << std::setw(6) << row["targetPercent"].get<double>();
    if (row.contains("refused"))
    {
        std::cout << "  " << row["refused"].get<std::string>() << '\n';
        return;
    }
    std::cout << std::setw(9) << row["trianglesReached"].get<std::size_t>() << std::fixed
              << std::setprecision(1);
    for (const char* column : {"areaPercent", "leastAreaPercent", "mostAreaPercent", "coveredPercent"})
        std::cout << std::setw(9) << row[column].get<double>();
    std::cout << std::setprecision(4) << std::setw(9) << row["luminanceError"].get<double>() << '\n'
              << std::defaultfloat;
}

void addDifference(Json& row, const SimplifiedLevel& level, const core::ImageDifference& difference)
{
    row["trianglesReached"] = level.mesh.faces.size();
    row["areaPercent"] = 100.0 * difference.areaRatio;
    row["leastAreaPercent"] = 100.0 * difference.leastAreaRatio;
    row["mostAreaPercent"] = 100.0 * difference.mostAreaRatio;
    row["coveredPercent"] = 100.0 * difference.covered;
    row["luminanceError"] = difference.luminance;
    row["ms"] = level.ms;
}

std::vector<std::size_t> facesOfTargets(const std::vector<double>& percents, std::size_t faces)
{
    std::vector<std::size_t> targets;
    for (const double percent : percents)
        targets.push_back(static_cast<std::size_t>(
            std::max(1.0, std::round(percent / 100.0 * static_cast<double>(faces)))));
    return targets;
}

/// Measures the levels of one tool, adds a row each to `results`, and writes their images if a folder is
/// named.
foundation::Outcome compareImages(const SimplifyTool& tool, const SimplifyTask& task,
                                  const core::ImageMeter& meter, const SilhouetteRequest& request,
                                  const std::string& name, Json& results)
{
    const auto levels = tool.run(task);
    ImageRows images(meter);
    if (!request.imageFolder.empty()) images.add(task.mesh);
    for (std::size_t i = 0; i < task.targets.size(); ++i)
    {
        Json row{{"tool", tool.name}, {"targetPercent", request.targetPercents[i]}};
        if (levels)
            addDifference(row, (*levels)[i], meter.measure((*levels)[i].mesh));
        else
            row["refused"] = levels.error().message();
        if (levels && !request.imageFolder.empty()) images.add((*levels)[i].mesh);
        printSilhouetteRow(row);
        results.push_back(std::move(row));
    }
    if (request.imageFolder.empty()) return foundation::success();
    return images.write(request.imageFolder / (name + '.' + tool.name + ".png"));
}

foundation::Result<Json> compareModelImages(const std::string& file, const SilhouetteRequest& request,
                                            OutputNames& names)
{
    auto model = readClean(file, request.models.limits);
    if (!model) return model.error();
    core::Mesh& mesh = model->read.imported.mesh;
    if (request.checker) addCheckerCoordinates(mesh);
    const auto looks = request.checker ? checkerLooks(mesh.materials.size())
                                       : materialLooks(mesh, model->read.imported.states);
    const core::ImageMeter meter(mesh, looks, request.images);
    const core::Mesh shape = shapeOf(mesh);
    const std::vector<std::size_t> targets = facesOfTargets(request.targetPercents, mesh.faces.size());
    Json row{{"model", file}, {"triangles", mesh.faces.size()}, {"results", Json::array()}};
    std::cout << file << ": " << mesh.faces.size()
              << " triangles\n  tool               %triangles     area    least     most  covered    light\n";
    const std::string name = names.nameFor(file);
    for (const SimplifyTool& tool : simplifyTools())
    {
        if (std::find(request.tools.begin(), request.tools.end(), tool.name) == request.tools.end()) continue;
        const SimplifyTask task{mesh,    shape, true,
                                targets, 60.0,  materialColours(mesh, model->read.imported.states)};
        if (const auto done = compareImages(tool, task, meter, request, name, row["results"]); !done)
            return done.error();
    }
    return row;
}

foundation::Result<terminal::Report> compareSilhouettes(SilhouetteRequest request)
{
    std::sort(request.targetPercents.rbegin(), request.targetPercents.rend());
    if (!request.imageFolder.empty())
        if (const auto made = makeFolder(request.imageFolder); !made) return made.error();
    OutputNames names;
    return forEachModel(
        request.models.files,
        [&](const std::string& file) { return compareModelImages(file, request, names); }, kComparer);
}

std::vector<std::string> seamToolNames()
{
    std::vector<std::string> names;
    for (const SimplifyTool& tool : simplifyTools())
        if (tool.keepsSeams) names.push_back(tool.name);
    return names;
}

} // namespace

void addCompareSilhouette(CLI::App& app, Chosen& chosen)
{
    const auto request = std::make_shared<SilhouetteRequest>();
    CLI::App* sub = app.add_subcommand(
        "silhouette",
        "levels by their images from all around: area of the silhouette, pixels covered, shade");
    addModelOptions(*sub, request->models, chosen.jsonFile);
    sub->add_option("--tools", request->tools, "simplifiers that keep seams, with commas between (optimal)")
        ->delimiter(',')
        ->check(CLI::IsMember(seamToolNames()));
    sub->add_option("--targets", request->targetPercents, "triangles to keep, per cent (5,1)")
        ->delimiter(',')
        ->check(terminal::between(0.001, 100.0));
    sub->add_option("--views", request->images.views, "directions all around (16)")
        ->check(terminal::between(1, 256));
    sub->add_option("--size", request->images.sizePx, "width and height of each image, pixels (256)")
        ->check(terminal::between(16, 2048));
    sub->add_flag("--checker", request->checker,
                  "put generated texture coordinates with seams and a chequered texture on every model");
    sub->add_option(
        "--images", request->imageFolder,
        "write NAME.TOOL.png to this folder: the original, and below it each level, in four views");
    sub->callback([&chosen, request] { chosen.work = [request] { return compareSilhouettes(*request); }; });
}

} // namespace pmtool
