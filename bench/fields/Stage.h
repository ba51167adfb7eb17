// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include <nlohmann/json.hpp>

#include <osgTerrainROAM/Atmosphere>

#include "Request.h"
#include "objects/PipelineCount.h"

namespace fieldbench
{

/// Eyes along two paths over the landscape: at a driver's height, and 120 m up, looking down a little.
struct Path
{
    const char* name;
    double heightM, pitch, stepM;
};
constexpr Path kPaths[] = {{"drive", 2.0, 0.0, 0.6}, {"flight", 120.0, -0.25, 2.0}};

constexpr double kHighDeg = 40.0; ///< of the picture

/// Where contestants fly, one after the other, and where their pictures are kept for comparison.
class Stage
{
public:
    using Json = nlohmann::ordered_json;

    Stage(osgOffscreen::OffscreenViewer& viewer, const Request& request);

    /// The times of a path's frames, the quickest of some rounds, or, of none, those of the pictures that are compared.
    Json fly(const std::string& name, osg::Node& objects, const Path& path, int frames);

    /// Root of the mean square of the levels by which two contestants' pictures differ.
    double difference(const std::string& name, const std::string& other, const Path& path) const;

    void clear();

private:
    double frameMs(const Path& path, int frame);
    void look(const Path& path, int frame);
    void keep(const osg::Image& picture, const std::string& name) const;

    osgOffscreen::OffscreenViewer& _viewer;
    objectbench::PipelineCount _count;
    const Request& _request;
    osg::ref_ptr<osgTerrainROAM::Atmosphere> _air;
    double _timeS = 0.0; ///< it never goes back, or switches would stand still
    std::map<std::string, std::vector<osg::ref_ptr<osg::Image>>> _pictures;
};

} // namespace fieldbench
