// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include <nlohmann/json.hpp>

#include <osgSky/Atmosphere>

#include "Request.h"
#include "objects/PipelineCount.h"

namespace fieldbench
{

/// A straight path of the camera over the landscape: its height above the ground, the slope of its line of
/// sight (negative: down), and the distance between frames.
struct Path
{
    const char* name;
    double heightM, pitch, stepM;
};
/// The height of a driver, and 120 m looking slightly down.
constexpr Path kPaths[] = {{"drive", 2.0, 0.0, 0.6}, {"flight", 120.0, -0.25, 2.0}};

constexpr double kHighDeg = 40.0; ///< vertical field of view

/// The scene that contestants are flown in one after the other; it keeps their images for comparison.
class Stage
{
public:
    using Json = nlohmann::ordered_json;

    Stage(osgOffscreen::OffscreenViewer& viewer, const Request& request);

    /// Flies a path and returns the times of its frames, the least of some rounds; with 0 frames, those of
    /// the compared images.
    Json fly(const std::string& name, osg::Node& objects, const Path& path, int frames);

    /// Returns the root mean square difference of the images of two contestants, in levels of 255.
    double difference(const std::string& name, const std::string& other, const Path& path) const;

    /// Removes the objects from the scene.
    void clear();

private:
    double frameMs(const Path& path, int frame);
    void look(const Path& path, int frame);
    void keep(const osg::Image& picture, const std::string& name) const;

    osgOffscreen::OffscreenViewer& _viewer;
    objectbench::PipelineCount _count;
    const Request& _request;
    osg::ref_ptr<osgSky::Atmosphere> _air;
    double _timeS = 0.0; ///< it only increases, because switching between levels needs it
    std::map<std::string, std::vector<osg::ref_ptr<osg::Image>>> _pictures;
};

} // namespace fieldbench
