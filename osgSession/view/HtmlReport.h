// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <foundation/Result.h>

#include "view/FrameStatistics.h"

namespace trainer
{

/// The content of a report besides the statistics.
struct ReportContent
{
    std::string title;
    std::vector<std::pair<std::string, std::string>>
        facts;                ///< name and value, in order: scenario, terrain, size, …
    std::string contactSheet; ///< file beside the report, as its <img>; empty: none
    std::string video;        ///< likewise, as its <video>
};

/// Makes one HTML page that needs no network: facts, images, a table of medians and 99th percentiles, and
/// plots of triangles, changes, adaptation time and error over the simulated time.
std::string reportHtml(const ReportContent& content, const std::vector<FrameStatistics>& frames);

/// Errors: the file cannot be written; no partial file remains.
foundation::Outcome writeReport(const ReportContent& content, const std::vector<FrameStatistics>& frames,
                                const std::filesystem::path& file);

} // namespace trainer
