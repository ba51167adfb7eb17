// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <system_error>
#include <utility>

#include <osgOffscreen/FrameCapture>

namespace osgOffscreen
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;

Result<std::unique_ptr<FrameCapture>> FrameCapture::begin(osg::GraphicsContext* context,
                                                          std::filesystem::path folder)
{
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed)
        return Error{folder.string(), "this folder cannot be made: " + failed.message(),
                     "choose a folder that can be written to"};
    return std::unique_ptr<FrameCapture>(new FrameCapture(context, std::move(folder)));
}

FrameCapture::FrameCapture(osg::GraphicsContext* context, std::filesystem::path folder)
    : _context(context),
      _folder(std::move(folder)),
      _grabber(new FrameGrabber([this](const GrabbedFrame& frame) { receive(frame); }))
{
    _context->setSwapCallback(_grabber);
}

FrameCapture::~FrameCapture()
{
    // Without finish() the last frames are dropped; the callback must not outlive this.
    if (_context->getSwapCallback() == _grabber) _context->setSwapCallback(nullptr);
}

std::filesystem::path FrameCapture::pathOf(std::size_t frame) const
{
    char name[32];
    std::snprintf(name, sizeof name, "frame_%05zu.png", frame);
    return _folder / name;
}

void FrameCapture::receive(const GrabbedFrame& frame)
{
    const Outcome given = _writer.write(frame.picture, pathOf(_next++));
    const std::lock_guard lock(_mutex);
    if (!given && !_error) _error = given.error();
}

Outcome FrameCapture::outcome() const
{
    const std::lock_guard lock(_mutex);
    if (_error) return *_error;
    return foundation::success();
}

Result<std::size_t> FrameCapture::finish()
{
    if (_context->getSwapCallback() == _grabber) _context->setSwapCallback(nullptr);
    _grabber->drain(_context);
    const Outcome all = _writer.finish();
    if (!all) return all.error();
    std::error_code ignored;
    for (std::size_t stale = _next; std::filesystem::remove(pathOf(stale), ignored); ++stale)
    {
    }
    return _writer.written();
}

} // namespace osgOffscreen
