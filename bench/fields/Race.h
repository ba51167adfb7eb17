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

    /// Building, memory, and the frames of each path; into the report, if it was asked for.
    void enter(Json& report, const std::string& name, const Make& make, int frames);
    void compare(Json& report, const std::string& name);

    Stage& _stage;
    const Request& _request;
};

} // namespace fieldbench
