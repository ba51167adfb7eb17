// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "Contestants.h"
#include "Stage.h"

namespace fieldbench
{

/// Runs the contestants on one landscape, one after the other.
class Race
{
public:
    using Json = Stage::Json;

    Race(Stage& stage, const Request& request) : _stage(stage), _request(request) {}

    /// Runs all that the request names and compares ours and the discrete levels with full detail.
    Json run(const Shapes& shapes, const std::vector<osgPMObjects::FieldInstance>& instances);

private:
    using Make = std::function<osg::ref_ptr<osg::Node>()>;

    /// Measures building, memory, the frames of each path, and the error of the image when full detail has
    /// been flown.
    Json flown(const std::string& name, const Make& make, int frames);

    /// Returns a row for each number of pixels that a face may cover.
    Json flownAt(const std::string& name, const std::vector<double>& trianglesPx,
                 const std::function<osg::ref_ptr<osg::Node>(double)>& make);

    Stage& _stage;
    const Request& _request;
};

} // namespace fieldbench
