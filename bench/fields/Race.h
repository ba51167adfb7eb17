// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "Contestants.h"
#include "Stage.h"

namespace fieldbench
{

/// The contestants of one landscape, one after the other.
class Race
{
public:
    using Json = Stage::Json;

    Race(Stage& stage, const Request& request) : _stage(stage), _request(request) {}

    /// All that the request asks for, and how far ours and the discrete levels are from full detail.
    Json run(const Shapes& shapes, const std::vector<osgPMObjects::FieldInstance>& instances);

private:
    using Make = std::function<osg::ref_ptr<osg::Node>()>;

    /// Building, memory, the frames of each path, and, where full detail has flown, the error of the picture.
    Json flown(const std::string& name, const Make& make, int frames);

    /// A row for each of the pixels that a face may cover.
    Json flownAt(const std::string& name, const std::vector<double>& trianglesPx,
                 const std::function<osg::ref_ptr<osg::Node>(double)>& make);

    Stage& _stage;
    const Request& _request;
};

} // namespace fieldbench
