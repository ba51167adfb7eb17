// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include <gtest/gtest.h>

#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/ReadModel>

namespace progressive
{

/// A model as it was read, and as a progressive object.
struct RealProgressive
{
    osg::ref_ptr<osg::Node> original;
    osgPMObjects::ProgressiveModel model;

    osgPMObjects::ProgressiveNode& node() const { return *model.node; }
    const osgPMObjects::ProgressiveShape& shape() const { return *model.node->shape(); }

    /// Returns none, and fails the test, if the model cannot be read or made progressive.
    static std::optional<RealProgressive> of(const std::filesystem::path& file)
    {
        const auto read = osgPMObjects::readModelNode(file);
        if (!read)
        {
            ADD_FAILURE() << read.error().message();
            return std::nullopt;
        }
        auto made = osgPMObjects::makeProgressive(**read, file.string(), {.ladder = std::nullopt});
        if (!made)
        {
            ADD_FAILURE() << made.error().message();
            return std::nullopt;
        }
        return RealProgressive{*read, std::move(*made)};
    }
};

} // namespace progressive
