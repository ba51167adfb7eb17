// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osg/State>

#include <osgOffscreen/EglContext>
#include <osgOffscreen/OffscreenContext>
#include <osgOffscreen/ProcessorDrawing>
#ifdef OSGTRAINER_WITH_OSMESA
#include <osgOffscreen/OSMesaContext>
#endif

namespace osgOffscreen
{

using foundation::Error;
using foundation::Result;

namespace
{

osg::GraphicsContext::Traits* traitsOf(const OffscreenSettings& settings)
{
    osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
    traits->x = 0;
    traits->y = 0;
    traits->width = settings.widthPx;
    traits->height = settings.heightPx;
    traits->red = traits->green = traits->blue = traits->alpha = 8;
    traits->depth = 24;
    traits->stencil = 8;
    traits->doubleBuffer = false;
    traits->pbuffer = true;
    traits->samples = static_cast<unsigned>(settings.samples);
    traits->sampleBuffers = settings.samples > 1 ? 1 : 0;
    return traits.release();
}

/// The place of errors.
std::string placeOf(const OffscreenSettings& settings)
{
    return "offscreen context (" + std::string(backendName(settings.backend)) + ")";
}

osg::ref_ptr<OffscreenContext> makeContext(const OffscreenSettings& settings)
{
#ifdef OSGTRAINER_WITH_OSMESA
    if (settings.backend == Backend::osmesa) return new OSMesaContext(settings);
#endif
    return new EglContext(settings);
}

std::string glText(GLenum name)
{
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

/// Tells whether the current context has the core profile; GL_CONTEXT_PROFILE_MASK is known from 3.2 on.
bool hasCoreProfile(const osg::GLExtensions& gl)
{
    constexpr GLenum kProfileMask = 0x9126;
    constexpr GLint kCore = 1;
    GLint mask = 0;
    if (gl.glVersion >= 3.2F) glGetIntegerv(kProfileMask, &mask);
    return (mask & kCore) != 0;
}

} // namespace

Result<osg::ref_ptr<OffscreenContext>> OffscreenContext::create(const OffscreenSettings& settings)
{
    const std::string place = placeOf(settings);
    if (!isAvailable(settings.backend))
        return Error{place, "this build leaves it out", "choose another backend, or build with it"};
    if (settings.widthPx < 1 || settings.heightPx < 1)
        return Error{place,
                     "an image of " + std::to_string(settings.widthPx) + "x" +
                         std::to_string(settings.heightPx) + " pixels",
                     "give a width and height of at least 1"};
    osg::ref_ptr<OffscreenContext> context = makeContext(settings);
    if (!context->realize())
        return context->error().value_or(Error{place, "could not be made", "try another backend"});
    return context;
}

OffscreenContext::OffscreenContext(const OffscreenSettings& settings) : _settings(settings)
{
    _traits = traitsOf(settings);
    setState(new osg::State);
    getState()->setGraphicsContext(this);
    getState()->setContextID(osg::GraphicsContext::createNewContextID());
}

void OffscreenContext::setNative(const foundation::Outcome& made)
{
    _hasNative = static_cast<bool>(made);
    if (!made) _error = made.error();
}

bool OffscreenContext::fail(std::string what, std::string remedy)
{
    _error = Error{placeOf(_settings), std::move(what), std::move(remedy)};
    return false;
}

bool OffscreenContext::realizeImplementation()
{
    if (_isRealized) return true;
    if (!_hasNative) return false;
    if (!makeNativeCurrent()) return fail("could not be made current", "try another backend");

    const std::string version = glText(GL_VERSION);
    osg::GLExtensions* gl = nullptr;
    if (!version.empty()) gl = osg::GLExtensions::Get(getState()->getContextID(), true);
    bool drawable = false;
    foundation::Outcome recent = foundation::success();
    if (gl)
    {
        const std::string renderer = glText(GL_RENDERER);
        leaveOutAnisotropy(*gl, renderer);
        _rendererName = renderer + " | " + version;
        recent = checkOpenGl(version, hasCoreProfile(*gl), _settings.leastOpenGl, placeOf(_settings));
    }
    if (gl && recent)
    {
        drawable = _frameBuffer.create(*gl, _settings.widthPx, _settings.heightPx, _settings.samples,
                                       _settings.sampling);
    }
    if (drawable)
    {
        _frameBuffer.bindForDrawing(*gl);
        setDefaultFboId(_frameBuffer.drawId());
        _isRealized = true;
    }
    releaseNative();
    if (!gl)
        return fail("GL calls do not reach it",
                    "link the program through osgTrainer::osgOffscreen, so that OSMesa comes before libGL");
    if (!recent)
    {
        _error = recent.error();
        return false;
    }
    if (!drawable)
        return fail("no framebuffer of " + std::to_string(_settings.widthPx) + "x" +
                        std::to_string(_settings.heightPx) + " with " + std::to_string(_settings.samples) +
                        " samples",
                    "ask for a smaller image, or for 1 sample a pixel");
    return true;
}

void OffscreenContext::closeImplementation()
{
    if (!_hasNative) return;
    if (_isRealized && makeNativeCurrent())
    {
        _frameBuffer.destroy(*osg::GLExtensions::Get(getState()->getContextID(), true));
        releaseNative();
    }
    destroyNative();
    _hasNative = false;
    _isRealized = false;
}

bool OffscreenContext::makeCurrentImplementation()
{
    return _isRealized && makeNativeCurrent();
}

bool OffscreenContext::makeContextCurrentImplementation(osg::GraphicsContext*)
{
    return makeCurrentImplementation();
}

bool OffscreenContext::releaseContextImplementation()
{
    return _hasNative && releaseNative();
}

void OffscreenContext::swapBuffersImplementation()
{
    glFlush(); // one buffer: nothing to exchange
}

void OffscreenContext::bindForReading()
{
    _frameBuffer.bindForReading(*getState()->get<osg::GLExtensions>());
}

void OffscreenContext::bindForDrawing()
{
    _frameBuffer.bindForDrawing(*getState()->get<osg::GLExtensions>());
}

} // namespace osgOffscreen
