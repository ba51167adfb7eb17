// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "terminal/Progress.h"
#include "terraintool/mt/MtRequest.h"

namespace terraintool
{

/// Shows how far a build is.
class BuildProgress
{
public:
    explicit BuildProgress(const MtBuildRequest& request) : _request(request) {}

    /// The options of the request, with progress. This object must stay.
    osgMultiTriangulation::core::ForestOptions options()
    {
        osgMultiTriangulation::core::ForestOptions options = _request.options;
        options.progress = [this](std::uint32_t done, std::uint32_t all)
        {
            if (!_bar) _bar.emplace(_request.output.string(), all - done + 1);
            _bar->advance();
            return true;
        };
        return options;
    }

    void end() { _bar.reset(); }

private:
    const MtBuildRequest& _request;
    std::optional<terminal::Progress> _bar;
};

/// Prints what was built, and returns its row of the table.
terminal::Report reportOfBuild(const MtBuildRequest& request, std::uint64_t points, std::uint64_t triangles,
                               const osgMultiTriangulation::core::ForestReport& built);

} // namespace terraintool
