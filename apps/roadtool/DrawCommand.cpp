// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <utility>

#include <foundation/WholeFile.h>

#include <osgRoads/core/read/ReadNetwork.h>

#include "roadtool/Commands.h"
#include "roadtool/Pictures.h"

namespace roadtool
{

namespace
{

/// Writes the images that were asked for and tells their names. Both are made before one is written: where
/// memory lacks, none is.
foundation::Outcome writeImages(const TopView& view, const Request& request, nlohmann::ordered_json& row)
{
    const std::string svg = request.svgFile.empty() ? std::string() : svgText(view, request.pixels);
    const RgbImage image = request.pngFile.empty() ? RgbImage() : paintedImage(view, request.pixels);
    if (!request.svgFile.empty())
    {
        const auto written = foundation::writeWholeFile(request.svgFile, svg);
        if (!written) return written.error();
        row["svg"] = request.svgFile.string();
    }
    if (!request.pngFile.empty())
    {
        const auto written = writePng(image, request.pngFile);
        std::error_code none;
        if (!written && !request.svgFile.empty()) std::filesystem::remove(request.svgFile, none);
        if (!written) return written.error();
        row["png"] = request.pngFile.string();
        row["width"] = image.width;
        row["height"] = image.height;
    }
    return foundation::success();
}

} // namespace

foundation::Result<Report> draw(const Request& request)
{
    if (request.svgFile.empty() && request.pngFile.empty())
        return foundation::Error{"draw", "no image is asked for", "add --svg FILE or --png FILE"};
    if (request.files.size() != 1)
        return foundation::Error{"draw", "more than one file", "draw one file at a time"};
    const std::string& file = request.files.front();
    const auto read = osgRoads::core::readNetwork(file);
    if (!read) return read.error();
    const TopView view = topView(read->network);
    Report report;
    nlohmann::ordered_json row;
    row["file"] = file;
    row["polygons"] = view.polygons.size();
    row["widthM"] = view.bounds.most.x - view.bounds.least.x;
    row["heightM"] = view.bounds.most.y - view.bounds.least.y;
    const auto written = writeImages(view, request, row);
    if (!written) return written.error();
    std::cout << file << ": " << row.dump() << '\n';
    report.json["files"].push_back(std::move(row));
    return report;
}

} // namespace roadtool
