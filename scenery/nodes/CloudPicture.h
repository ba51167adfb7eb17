// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

#include <osg/FrameBufferObject>
#include <osg/Geometry>
#include <osg/Texture2D>
#include <osg/buffered_value>

namespace scenery
{

/// The picture of the clouds, smaller than the one that is drawn: colour with what shines through, and
/// distance. One for each context and size; whoever draws it first makes it.
/// Threads: of the drawing of its context.
class CloudPicture : public osg::Referenced
{
public:
    struct Target
    {
        osg::ref_ptr<osg::Texture2D> colour, away;
        osg::ref_ptr<osg::FrameBufferObject> buffer;
        int widthPx = 0, heightPx = 0;
    };

    void setPixelsPerRay(int pixels) { _pixelsPerRay = pixels; }

    /// Returns the one for the viewport of `state`.
    Target& targetFor(osg::State& state) const;

private:
    int _pixelsPerRay = 4;
    mutable osg::buffered_object<std::map<std::pair<int, int>, Target>> _targets;
};

/// A rectangle over the whole picture that is drawn into a CloudPicture.
class CloudRays : public osg::Geometry
{
public:
    explicit CloudRays(CloudPicture* picture);
    void drawImplementation(osg::RenderInfo& info) const override;

private:
    osg::ref_ptr<CloudPicture> _picture;
};

/// A rectangle over the whole picture with a CloudPicture in two texture units.
class CloudSheet : public osg::Geometry
{
public:
    static constexpr unsigned int kColourUnit = 0, kAwayUnit = 1;

    explicit CloudSheet(CloudPicture* picture);
    void drawImplementation(osg::RenderInfo& info) const override;

private:
    osg::ref_ptr<CloudPicture> _picture;
};

} // namespace scenery
