// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <utility>

#include <foundation/WholeFile.h>

#include <osgRoads/core/read/ReadNetwork.h>

#include "roadtool/Commands.h"
#include "roadtool/Pictures.h"

namespace roadtool
{

namespace
{

/// Writes the images that were asked for and tells their names.
foundation::Outcome writeImages(const TopView& view, const Request& request, nlohmann::ordered_json& row)
{
    if (!request.svgFile.empty())
    {
        const auto written = foundation::writeWholeFile(request.svgFile, svgText(view, request.pixels));
        if (!written) return written.error();
        row["svg"] = request.svgFile.string();
    }
    if (!request.pngFile.empty())
    {
        const RgbImage image = paintedImage(view, request.pixels);
        const auto written = writePng(image, request.pngFile);
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
