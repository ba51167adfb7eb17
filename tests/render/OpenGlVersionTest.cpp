// SPDX-License-Identifier: Apache-2.0
// What a driver must offer. The contexts are real ones that offer less than a trainer needs: OpenGL ES, and
// the core profile.
#include <gtest/gtest.h>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include <osgOffscreen/OffscreenContext>

using osgOffscreen::checkOpenGl;
using osgOffscreen::kEverythingNeeds;

namespace
{

std::string wordsOf(std::string_view offered, bool isCore = false)
{
    const auto checked = checkOpenGl(offered, isCore, kEverythingNeeds, "context");
    return checked ? "" : checked.error().message();
}

/// Returns GL_VERSION of a context that EGL makes for an API with these attributes; empty without one.
std::string versionOf(EGLenum api, EGLint renderable, const EGLint* attributes)
{
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(api)) return "";
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, renderable, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1) return "";
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
    std::string version;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        if (const GLubyte* const text = glGetString(GL_VERSION))
            version = reinterpret_cast<const char*>(text);
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    return version;
}

} // namespace

TEST(OpenGlVersion, IsReadFromWhatDriversSay)
{
    EXPECT_EQ(wordsOf("3.3"), "");
    EXPECT_EQ(wordsOf("3.3.0 NVIDIA 535.183.01"), "");
    EXPECT_EQ(wordsOf("4.5 (Compatibility Profile) Mesa 22.3.6"), "");
    EXPECT_EQ(wordsOf("10.0"), "");
    for (const char* old : {"3.2 Mesa 9.1", "2.1 Mesa 22.3.6", "1.4 (2.1 Mesa 10.5)", "1.1.0"})
    {
        const std::string words = wordsOf(old);
        EXPECT_NE(words.find(std::string("'") + old + "', which is too old"), std::string::npos) << words;
        EXPECT_NE(words.find("OpenGL 3.3"), std::string::npos) << words;
    }
    EXPECT_NE(wordsOf("").find("names no version"), std::string::npos);
    EXPECT_NE(wordsOf("three").find("names no version"), std::string::npos);
    EXPECT_NE(wordsOf("3").find("names no version"), std::string::npos);
}

TEST(OpenGlVersion, OfAnEsContextIsRefused)
{
    const EGLint two[] = {EGL_CONTEXT_MAJOR_VERSION, 2, EGL_NONE};
    const std::string version = versionOf(EGL_OPENGL_ES_API, EGL_OPENGL_ES2_BIT, two);
    ASSERT_TRUE(version.starts_with("OpenGL ES ")) << version;
    EXPECT_NE(wordsOf(version).find("not desktop OpenGL"), std::string::npos) << wordsOf(version);
}

TEST(OpenGlVersion, OfACoreProfileIsRefused)
{
    const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION,
                           3,
                           EGL_CONTEXT_MINOR_VERSION,
                           3,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
    const std::string version = versionOf(EGL_OPENGL_API, EGL_OPENGL_BIT, core);
    ASSERT_NE(version.find("Core Profile"), std::string::npos) << version;
    EXPECT_NE(wordsOf(version, true).find("core profile alone"), std::string::npos);
}

TEST(OpenGlVersion, ThatNoDriverHasIsAnErrorOfTheContext)
{
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = settings.heightPx = 16;
    settings.leastOpenGl = kEverythingNeeds;
    EXPECT_TRUE(osgOffscreen::OffscreenContext::create(settings));
    settings.leastOpenGl = {9, 9};
    const auto context = osgOffscreen::OffscreenContext::create(settings);
    ASSERT_FALSE(context);
    EXPECT_NE(context.error().what.find("OpenGL 9.9"), std::string::npos) << context.error().message();
}
