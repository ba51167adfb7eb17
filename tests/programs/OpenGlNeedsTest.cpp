// SPDX-License-Identifier: Apache-2.0
// A driver that offers less than the trainer draws with: one line that says what is offered and what is
// needed. Mesa 22.3 alone has no driver below OpenGL 3.3 that runs without hardware of its own, so its
// override stands for an old one here.
// Tried by hand with one that really offers less: virgl, whose host has OpenGL ES 3.0, offers 2.1 and is
// refused in the same words. tests/render/OpenGlVersionTest.cpp looks at real contexts of other kinds;
// softpipe is a real driver with one sample a pixel.
#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

/// Runs a tour of one frame with variables of the environment, "NAME=VALUE".
ProgramRun tourWith(const Workplace& place, std::vector<std::string> command,
                    const std::vector<std::string>& options)
{
    command.insert(command.begin(), "env");
    command.insert(command.end(), {OSGTRAINER_TRAINER, "tour", "--no-world", place.hill(), "--frames", "1",
                                   "--size", "32x18"});
    command.insert(command.end(), options.begin(), options.end());
    return runProgram(command);
}

TEST(OpenGlNeeds, AnOldOpenGlIsRefusedInOneLine)
{
    const Workplace place;
    for (const char* backend : {"osmesa", "egl"})
        EXPECT_TRUE(
            failsWith(tourWith(place, {"MESA_GL_VERSION_OVERRIDE=2.1", "MESA_GLSL_VERSION_OVERRIDE=120"},
                               {"--backend", backend}),
                      1, "trainer",
                      {std::string("offscreen context (") + backend + ")", "'2.1", "too old", "OpenGL 3.3"}));
}

TEST(OpenGlNeeds, SoftpipeIsToldToTakeOneSample)
{
    const Workplace place;
    const std::vector<std::string> softpipe{"GALLIUM_DRIVER=softpipe", "LIBGL_ALWAYS_SOFTWARE=1"};
    EXPECT_TRUE(failsWith(tourWith(place, softpipe, {"--samples", "4"}), 1, "trainer",
                          {"with 4 samples", "1 sample a pixel"}));
    EXPECT_TRUE(succeeds(tourWith(place, softpipe, {"--samples", "1"})));
}

TEST(OpenGlNeeds, AreInTheHelp)
{
    const ProgramRun run = runTrainer({"--help"});
    EXPECT_TRUE(succeeds(run));
    EXPECT_NE(run.output.find("Needs OpenGL 3.3"), std::string::npos) << run.text();
}

} // namespace
