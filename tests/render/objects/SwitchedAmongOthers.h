// SPDX-License-Identifier: Apache-2.0
// A switching object among others, of glass and opaque, and the colours that its images may have.
#pragma once

#include <optional>

#include <osg/BlendFunc>
#include <osg/Geode>
#include <osg/Geometry>

#include "SwitchedScene.h"

namespace switched
{

inline const osg::Vec3d kFrom{0.1, -1.0, 0.25};

/// An unlit square across the view, at a distance in front of a point (behind it if below 0).
inline osg::ref_ptr<osg::Node> square(const osg::Vec3d& centre, double nearer, double sideways, double half,
                                      const osg::Vec4& colour)
{
    osg::Vec3d towards = kFrom;
    towards.normalize();
    osg::Vec3d right = osg::Vec3d(0, 0, 1) ^ towards;
    right.normalize();
    const osg::Vec3d up = towards ^ right;
    const osg::Vec3d corner = centre + towards * nearer + right * (sideways - half) - up * half;
    const osg::ref_ptr<osg::Geometry> quad =
        osg::createTexturedQuadGeometry(corner, right * (2.0 * half), up * (2.0 * half));
    const osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array(osg::Array::BIND_OVERALL, 1);
    (*colours)[0] = colour;
    quad->setColorArray(colours);
    osg::StateSet& state = *quad->getOrCreateStateSet();
    state.setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    if (colour.a() < 1.0F)
    {
        state.setAttributeAndModes(new osg::BlendFunc);
        state.setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    }
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(quad);
    return geode;
}

/// The object with a red square in front of it, a white one behind it, and panes of glass on either side.
struct Scene
{
    osg::ref_ptr<ProgressiveNode> node;
    osg::ref_ptr<osg::Group> all = new osg::Group;

    explicit Scene(const core::SwitchSettings& switching,
                   const osg::ref_ptr<ProgressiveShape>& shape = made())
        : node(new ProgressiveNode(shape))
    {
        EXPECT_TRUE(node->setSwitching(switching));
        const osg::BoundingSphere ball = node->drawable()->getBound();
        const double r = ball.radius();
        all->addChild(square(ball.center(), 1.3 * r, 0.3 * r, 0.15 * r, {1, 0, 0, 1}));
        all->addChild(square(ball.center(), -1.3 * r, -0.1 * r, 0.4 * r, {1, 1, 1, 1}));
        all->addChild(square(ball.center(), -1.2 * r, 0.4 * r, 0.3 * r, {0.1F, 0.1F, 0.9F, 0.5F}));
        all->addChild(square(ball.center(), 1.2 * r, -0.3 * r, 0.2 * r, {0.9F, 0.9F, 0.1F, 0.5F}));
        all->addChild(node);
    }

    std::unique_ptr<Stage> stage()
    {
        auto stage = Stage::of(*all, 1, 320, 240);
        stage->lookAt(node->drawable()->getBound(), 1.0, kFrom);
        stage->after(kFrameS);
        return stage;
    }
};

/// The levels of the switch: the second is so coarse that their outlines differ.
inline std::uint32_t finerSteps()
{
    return made()->progressive().stepCount / 2;
}
inline std::uint32_t coarserSteps()
{
    return made()->progressive().stepCount - 30;
}

/// Renders the scene with the object at rest at a level, or without it.
inline Picture atRest(std::optional<std::uint32_t> steps)
{
    Scene scene(by(core::SwitchMethod::blend));
    if (steps)
        EXPECT_TRUE(scene.node->setSelection(always(*steps)));
    else
        scene.node->setNodeMask(0);
    return scene.stage()->after(kFrameS);
}

struct Ends
{
    Picture finer = atRest(finerSteps()), coarser = atRest(coarserSteps()), behind = atRest({});

    static const Ends& get()
    {
        static const Ends ends;
        return ends;
    }
};

/// Counts pixels outside the range that some images span, channel by channel.
inline int outside(const osg::Image& picture, const std::vector<Picture>& ends, int tolerance)
{
    int count = 0;
    for (int y = 0; y < picture.t(); ++y)
        for (int x = 0; x < picture.s(); ++x)
        {
            bool isOutside = false;
            for (int channel = 0; channel < 3; ++channel)
            {
                int least = 255, most = 0;
                for (const Picture& end : ends)
                {
                    least = std::min<int>(least, end->data(x, y)[channel]);
                    most = std::max<int>(most, end->data(x, y)[channel]);
                }
                const int value = picture.data(x, y)[channel];
                isOutside |= value < least - tolerance || value > most + tolerance;
            }
            count += isOutside;
        }
    return count;
}

/// Counts pixels that are equal to those of none of some images.
inline int strangers(const osg::Image& picture, const std::vector<Picture>& ends)
{
    int count = 0;
    for (int y = 0; y < picture.t(); ++y)
        for (int x = 0; x < picture.s(); ++x)
            count +=
                std::none_of(ends.begin(), ends.end(),
                             [&](const Picture& end) {
                                 return std::equal(end->data(x, y), end->data(x, y) + 3, picture.data(x, y));
                             });
    return count;
}

/// Counts pixels of the red square that have another colour.
inline int lostRed(const osg::Image& picture, const osg::Image& behind)
{
    int count = 0;
    for (int y = 0; y < picture.t(); ++y)
        for (int x = 0; x < picture.s(); ++x)
        {
            const unsigned char *was = behind.data(x, y), *is = picture.data(x, y);
            const bool isRed = was[0] == 255 && was[1] == 0 && was[2] == 0;
            count += isRed && !std::equal(was, was + 3, is);
        }
    return count;
}

inline std::vector<Picture> picturesOfSwitch(Scene& scene, std::uint32_t from, std::uint32_t to, int frames)
{
    EXPECT_TRUE(scene.node->setSelection(always(from)));
    const auto stage = scene.stage();
    EXPECT_TRUE(scene.node->setSelection(always(to)));
    std::vector<Picture> pictures;
    for (int frame = 0; frame < frames; ++frame)
        pictures.push_back(stage->after(kFrameS));
    return pictures;
}

inline const std::vector<Picture>& endsAndBehind()
{
    static const std::vector<Picture> pictures{Ends::get().finer, Ends::get().coarser, Ends::get().behind};
    return pictures;
}

} // namespace switched
