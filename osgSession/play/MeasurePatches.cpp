// SPDX-License-Identifier: Apache-2.0
#include "MeasurePatches.h"

#include <iomanip>
#include <sstream>

#include <osg/GraphicsContext>
#include <osg/Notify>
#include <osg/Timer>
#include <osgViewer/Viewer>

#include <osgTerrainROAM/core/roam/PatchBalance.h>

#include <osgOffscreen/FrameGrabber>
#include <osgTerrainROAM/RoamTerrain>

namespace trainer
{

namespace
{

constexpr int kExponents[] = {0, 2, 4, 6};
constexpr int kFrames = 16;

/// Reads back each frame, so that it is finished when its time is taken.
class EveryPicture
{
public:
    explicit EveryPicture(const std::vector<osg::ref_ptr<osg::GraphicsContext>>& contexts)
        : _contexts(contexts)
    {
        for (const auto& context : _contexts)
        {
            _grabbers.push_back(new osgOffscreen::FrameGrabber([](const auto&) {}, 0));
            context->setSwapCallback(_grabbers.back());
        }
    }
    ~EveryPicture()
    {
        for (std::size_t i = 0; i < _contexts.size(); ++i)
        {
            _grabbers[i]->drain(_contexts[i]);
            _contexts[i]->setSwapCallback(nullptr);
        }
    }
    EveryPicture(const EveryPicture&) = delete;
    EveryPicture& operator=(const EveryPicture&) = delete;

private:
    const std::vector<osg::ref_ptr<osg::GraphicsContext>>& _contexts;
    std::vector<osg::ref_ptr<osgOffscreen::FrameGrabber>> _grabbers;
};

std::string textOf(const osgTerrainROAM::core::PatchBalance& balance)
{
    std::ostringstream text;
    text << "patch exponent " << balance.exponent << " draws fastest here (" << std::fixed
         << std::setprecision(1);
    for (std::size_t i = 0; i < balance.rows.size(); ++i)
        text << (i > 0 ? ", " : "") << balance.rows[i].exponent << ": " << balance.rows[i].medianMs << " ms";
    text << " a frame)";
    return text.str();
}

} // namespace

std::string measurePatches(osgTerrainROAM::RoamTerrain& terrain, osgViewer::Viewer& viewer,
                           const std::vector<osg::ref_ptr<osg::GraphicsContext>>& contexts,
                           const std::function<void()>& moveEye)
{
    const EveryPicture pictures(contexts);
    const auto setPatches = [&](int exponent)
    {
        const auto set = terrain.drawable()->setPatchExponent(exponent);
        if (!set) osg::notify(osg::WARN) << set.error().message() << std::endl; // kExponents are allowed ones
    };
    const auto frameMs = [&](int exponent)
    {
        setPatches(exponent);
        moveEye();
        const osg::ElapsedTime time;
        viewer.frame();
        return time.elapsedTime_m();
    };
    const auto balance = osgTerrainROAM::core::measurePatchBalance(kExponents, kFrames, frameMs);
    setPatches(balance.exponent);
    return textOf(balance);
}

} // namespace trainer
