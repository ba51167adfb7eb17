// SPDX-License-Identifier: Apache-2.0
#include "window/OpenWindow.h"

#include <chrono>
#include <cstdlib>
#include <thread>

#include <osg/GLExtensions>
#include <osg/Notify>
#include <osg/State>

#include <osgOffscreen/OpenGlVersion>
#include <osgOffscreen/ProcessorDrawing>

namespace trainer
{

namespace
{

using Traits = osg::GraphicsContext::Traits;

// A display that has just started on a busy machine may not have its OpenGL yet.
constexpr int kTries = 3;
constexpr auto kBetweenTries = std::chrono::milliseconds(300);
constexpr int kLeftPx = 60, kTopPx = 40; ///< of a window without a place

/// Keeps OSG's own lines about a missing display from the terminal.
class QuietNotices
{
public:
    QuietNotices() : _level(osg::getNotifyLevel()) { osg::setNotifyLevel(osg::ALWAYS); }
    ~QuietNotices() { osg::setNotifyLevel(_level); }
    QuietNotices(const QuietNotices&) = delete;
    QuietNotices& operator=(const QuietNotices&) = delete;

private:
    osg::NotifySeverity _level;
};

/// The option that asked for the window, for messages; a ride has one without being asked.
const char* placeOf(const WindowRequest& request)
{
    if (!request.isWanted) return "the window";
    if (request.isFullscreen) return "--fullscreen";
    if (!request.keysFile.empty()) return "--keys";
    return request.byKeys ? "--by-keys" : "--window";
}

/// What says on which screen a window is.
osg::ref_ptr<Traits> screenOf(const WindowRequest& request)
{
    osg::ref_ptr<Traits> traits = new Traits;
    traits->readDISPLAY();
    traits->setUndefinedScreenDetailsToDefaultScreen();
    if (request.screen > 0) traits->screenNum = request.screen;
    return traits;
}

osg::ref_ptr<Traits> traitsOf(const WindowRequest& request, const FrameRequest& frames)
{
    osg::ref_ptr<Traits> traits = screenOf(request);
    const bool hasPlace = request.place.size() == 4;
    traits->x = hasPlace ? request.place[0] : kLeftPx;
    traits->y = hasPlace ? request.place[1] : kTopPx;
    traits->width = hasPlace ? request.place[2] : frames.widthPx;
    traits->height = hasPlace ? request.place[3] : frames.heightPx;
    traits->windowName = "trainer";
    traits->windowDecoration = true;
    traits->red = traits->green = traits->blue = traits->alpha = 8;
    traits->depth = 24;
    traits->stencil = 8;
    traits->doubleBuffer = true;
    traits->vsync = true;
    traits->samples = static_cast<unsigned>(frames.samples > 1 ? frames.samples : 0);
    traits->sampleBuffers = frames.samples > 1 ? 1 : 0;
    return traits;
}

/// Null: the display has no OpenGL for it.
osg::ref_ptr<osgViewer::GraphicsWindow> realizedWindow(Traits& traits)
{
    const osg::ref_ptr<osg::GraphicsContext> context = osg::GraphicsContext::createGraphicsContext(&traits);
    osg::ref_ptr<osgViewer::GraphicsWindow> window = dynamic_cast<osgViewer::GraphicsWindow*>(context.get());
    if (window && !window->realize()) window = nullptr;
    return window;
}

/// The same, tried again where it fails.
osg::ref_ptr<osgViewer::GraphicsWindow> realizedSoon(Traits& traits)
{
    osg::ref_ptr<osgViewer::GraphicsWindow> window = realizedWindow(traits);
    for (int tries = 1; !window && tries < kTries; ++tries)
    {
        std::this_thread::sleep_for(kBetweenTries);
        window = realizedWindow(traits);
    }
    return window;
}

/// Fills the whole screen.
foundation::Outcome coverScreen(Traits& traits)
{
    auto* const system = osg::GraphicsContext::getWindowingSystemInterface();
    unsigned width = 0, height = 0;
    for (int tries = 0; system && width == 0 && tries < kTries; ++tries)
    {
        if (tries > 0) std::this_thread::sleep_for(kBetweenTries);
        system->getScreenResolution(traits, width, height);
    }
    if (width == 0 || height == 0)
        return foundation::Error{"--fullscreen", "the screen tells no size", "leave it out"};
    traits.x = traits.y = 0;
    traits.width = static_cast<int>(width);
    traits.height = static_cast<int>(height);
    traits.windowDecoration = false;
    return foundation::success();
}

foundation::Outcome checkScreen(const WindowRequest& request, const Traits& traits)
{
    const auto lacking = [&](const std::string& what)
    {
        const std::string place = placeOf(request);
        return foundation::Error{place, what,
                                 "run it on a desktop or under xvfb-run, or " +
                                     (request.isWanted ? "leave " + place + " out" : "add --headless")};
    };
    const char* const display = std::getenv("DISPLAY");
    // Without a name OSG would take whatever display is the machine's first, which may be somebody else's.
    if (!display || !*display) return lacking("there is no display: DISPLAY is not set");
    auto* const system = osg::GraphicsContext::getWindowingSystemInterface();
    const osg::GraphicsContext::ScreenIdentifier first(traits.hostName, traits.displayNum, 0);
    const unsigned screens = system ? system->getNumScreens(first) : 0;
    if (screens == 0) return lacking("there is no display '" + std::string(display) + "'");
    if (request.screen >= static_cast<int>(screens))
        return foundation::Error{"--screen", "there are " + std::to_string(screens) + " screens",
                                 "count from 0"};
    return foundation::success();
}

/// What a window's driver says of itself.
struct Driver
{
    std::string version;
    std::string renderer;
};

std::string glText(GLenum name)
{
    const GLubyte* const text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

Driver driverOf(osgViewer::GraphicsWindow& window)
{
    window.makeCurrent();
    Driver driver{glText(GL_VERSION), glText(GL_RENDERER)};
    if (!driver.version.empty())
        osgOffscreen::leaveOutAnisotropy(*osg::GLExtensions::Get(window.getState()->getContextID(), true),
                                         driver.renderer);
    window.releaseContext();
    return driver;
}

foundation::Outcome checkGl(const std::string& version, const char* place)
{
    if (version.empty())
        return foundation::Error{place, "OpenGL's calls do not reach the window",
                                 "build with OSGTRAINER_WITH_OSMESA=OFF for a vendor's own driver"};
    return osgOffscreen::checkOpenGl(version, false, osgOffscreen::kEverythingNeeds, place);
}

} // namespace

foundation::Outcome checkDisplay(const WindowRequest& request)
{
    const QuietNotices quiet;
    return checkScreen(request, *screenOf(request));
}

foundation::Result<OpenedWindow> openWindow(const WindowRequest& request, const FrameRequest& frames)
{
    const QuietNotices quiet;
    const osg::ref_ptr<Traits> traits = traitsOf(request, frames);
    if (const auto there = checkScreen(request, *traits); !there) return there.error();
    if (request.isFullscreen)
        if (const auto covered = coverScreen(*traits); !covered) return covered.error();
    osg::ref_ptr<osgViewer::GraphicsWindow> window = realizedSoon(*traits);
    Driver driver = window ? driverOf(*window) : Driver();
    if (window && request.choosesSamples && traits->samples > 1 &&
        osgOffscreen::drawsOnProcessor(driver.renderer))
    {
        traits->samples = traits->sampleBuffers = 0;
        window->close();
        window = realizedSoon(*traits);
        if (window) driver = driverOf(*window);
    }
    if (!window)
        return foundation::Error{placeOf(request), "the display has no OpenGL for windows",
                                 "use one with GLX, try --samples 1, or leave --window out"};
    if (const auto recent = checkGl(driver.version, placeOf(request)); !recent) return recent.error();
    return OpenedWindow{window, osgOffscreen::drawsOnProcessor(driver.renderer)};
}

} // namespace trainer
