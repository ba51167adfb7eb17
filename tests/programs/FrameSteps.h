// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include <osg/Image>
#include <osg/ref_ptr>

inline constexpr double kMostLevels = 1.0;
inline constexpr double kMostLevelsOfSquare = 6.5; ///< a sign of 5 × 5 pixels that appears
inline constexpr int kSquarePx = 10;

/// How much two images differ, levels of 255.
struct Difference
{
    std::vector<double> squares; ///< mean of each square of kSquarePx
    double mean = 0.0;
};

using Frames = std::vector<osg::ref_ptr<osg::Image>>;

/// The images of a folder, in order of their names.
Frames framesIn(const std::filesystem::path& folder);

/// The differences of consecutive images.
std::vector<Difference> stepsOf(const Frames& images);

/// The mean of the steps' means.
double meanOf(const std::vector<Difference>& steps);

/// By how much the steps of one render are greater than those of the other, at most.
struct Excess
{
    double ofMean = -255.0, ofSquare = -255.0;
    std::size_t
        frame = 0,
        square = 0; ///< where that of a square is: the later frame; squares from the lower left, row by row

    bool isAllowed() const { return ofMean <= kMostLevels && ofSquare <= kMostLevelsOfSquare; }
};

Excess worstExcess(const std::vector<Difference>& steps, const std::vector<Difference>& fine);

std::ostream& operator<<(std::ostream& stream, const Excess& excess);

/// A copy with a grey square painted into it, as a thing that is shown too late.
osg::ref_ptr<osg::Image> withSquare(const osg::Image& image, int left, int bottom, int sidePx);
