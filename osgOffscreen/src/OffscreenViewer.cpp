// SPDX-License-Identifier: Apache-2.0
#include <osgOffscreen/OffscreenViewer>

namespace osgOffscreen
{

foundation::Result<std::unique_ptr<OffscreenViewer>>
OffscreenViewer::create(const OffscreenSettings& settings)
{
    foundation::Result<osg::ref_ptr<OffscreenContext>> context = OffscreenContext::create(settings);
    if (!context) return context.error();
    return std::unique_ptr<OffscreenViewer>(new OffscreenViewer(*context));
}

OffscreenViewer::OffscreenViewer(osg::ref_ptr<OffscreenContext> context)
    : _context(context), _viewer(new osgViewer::Viewer)
{
    const OffscreenSettings& settings = _context->settings();
    _viewer->setThreadingModel(osgViewer::Viewer::SingleThreaded);
    _viewer->setKeyEventSetsDone(0);
    camera().setGraphicsContext(_context);
    camera().setViewport(0, 0, settings.widthPx, settings.heightPx);
    camera().setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    camera().setProjectionMatrixAsPerspective(45.0, static_cast<double>(settings.widthPx) / settings.heightPx,
                                              1.0, 10000.0);
}

OffscreenViewer::~OffscreenViewer() = default;

void OffscreenViewer::frame(double simulationTimeS)
{
    _viewer->frame(simulationTimeS);
}

osg::ref_ptr<osg::Image> OffscreenViewer::picture(double simulationTimeS)
{
    osg::ref_ptr<osg::Image> picture;
    const osg::ref_ptr<FrameGrabber> grabber =
        new FrameGrabber([&picture](const GrabbedFrame& frame) { picture = frame.picture; }, 0);
    const osg::ref_ptr<osg::GraphicsContext::SwapCallback> before = _context->getSwapCallback();
    _context->setSwapCallback(grabber);
    frame(simulationTimeS);
    _context->setSwapCallback(before);
    grabber->drain(_context);
    return picture;
}

} // namespace osgOffscreen
