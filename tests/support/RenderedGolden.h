// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <osg/Image>

#include <osgOffscreen/ImageComparison>
#include <osgOffscreen/PngFile>

namespace rendered
{

/// Which picture of a golden counts. Beside tests/golden/NAME.png stands NAME.txt, one line naming the
/// machine class that wrote it (machineClass()). The same class: byte for byte. Another: at most 16 pixels by
/// one level. Another Mesa may have a second baseline, NAME.VARIANT.png with NAME.VARIANT.txt; any that
/// matches will do.
constexpr std::size_t kOtherClassPixels = 16;
constexpr int kOtherClassLevels = 1;

inline std::filesystem::path goldenFolder()
{
    return std::filesystem::path(OSGTRAINER_SOURCE_DIR) / "tests/golden";
}

/// Renderer and CPU features that llvmpipe's arithmetic depends on.
inline std::string machineClass(const std::string& rendererName)
{
    std::string text = rendererName + " |";
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx")) text += " avx";
    if (__builtin_cpu_supports("avx2")) text += " avx2";
    if (__builtin_cpu_supports("fma")) text += " fma";
    if (__builtin_cpu_supports("avx512f")) text += " avx512f";
#endif
    return text;
}

inline bool writesGoldens()
{
    const char* word = std::getenv("OSGTRAINER_WRITE_GOLDEN");
    return word && std::string(word) == "1";
}

inline std::string firstLine(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

inline testing::AssertionResult writeGolden(const osg::Image& actual, const std::string& name,
                                            const std::string& machine)
{
    const foundation::Outcome written = osgOffscreen::writePng(actual, goldenFolder() / (name + ".png"));
    if (!written) return testing::AssertionFailure() << written.error().message();
    std::ofstream(goldenFolder() / (name + ".txt")) << machine << '\n';
    return testing::AssertionSuccess() << "written anew";
}

/// Leaves NAME.actual.png and NAME.difference.png under golden-failures/ where the test runs (the build
/// folder).
inline std::string leaveEvidence(const osg::Image& actual, const osg::Image* expected,
                                 const std::string& name)
{
    const std::filesystem::path folder = std::filesystem::current_path() / "golden-failures";
    std::filesystem::create_directories(folder);
    std::string text = "; see " + folder.string();
    const foundation::Outcome kept = osgOffscreen::writePng(actual, folder / (name + ".actual.png"));
    if (!kept) text += " (" + kept.error().message() + ")";
    if (!expected) return text;
    const osg::ref_ptr<osg::Image> difference = osgOffscreen::differenceImage(actual, *expected);
    if (!difference) return text;
    const foundation::Outcome shown =
        osgOffscreen::writePng(*difference, folder / (name + ".difference.png"));
    return shown ? text : text + " (" + shown.error().message() + ")";
}

/// Compares a picture (RGB, as FrameGrabber gives it) with tests/golden/NAME.png.
/// `rendererName`: OffscreenContext::rendererName() of the context that drew it.
/// Use: EXPECT_TRUE(rendered::matchesGolden(*picture, "name", context.rendererName()));
/// Written anew only when the environment variable OSGTRAINER_WRITE_GOLDEN is 1.
inline testing::AssertionResult matchesGolden(const osg::Image& actual, const std::string& name,
                                              const std::string& rendererName)
{
    const std::string machine = machineClass(rendererName);
    if (writesGoldens()) return writeGolden(actual, name, machine);

    std::string found;
    osg::ref_ptr<osg::Image> nearest;
    for (const auto& entry : std::filesystem::directory_iterator(goldenFolder()))
    {
        const std::string stem = entry.path().stem().string();
        if (entry.path().extension() != ".png" || (stem != name && stem.rfind(name + ".", 0) != 0)) continue;
        const foundation::Result<osg::ref_ptr<osg::Image>> expected = osgOffscreen::readPng(entry.path());
        if (!expected) return testing::AssertionFailure() << expected.error().message();
        const osgOffscreen::ImageDifference difference = osgOffscreen::compareImages(actual, **expected);
        if (difference.identical()) return testing::AssertionSuccess();
        const bool sameClass = firstLine(goldenFolder() / (stem + ".txt")) == machine;
        if (!sameClass && difference.within(kOtherClassPixels, kOtherClassLevels))
            return testing::AssertionSuccess();
        found += stem + ": " + difference.message() + "; ";
        nearest = *expected;
    }
    if (!nearest) found = "tests/golden/" + name + ".png is missing; write it with OSGTRAINER_WRITE_GOLDEN=1";
    return testing::AssertionFailure() << found << leaveEvidence(actual, nearest, name);
}

} // namespace rendered
