// SPDX-License-Identifier: Apache-2.0
// Source: Foley et al., *Computer Graphics: Principles and Practice*, 1990, 3.6 (filling polygons).
#include <algorithm>
#include <cmath>

#include "roadtool/Pictures.h"

namespace roadtool
{

namespace
{

constexpr int kLinesOfRow = 4;

/// Paints one polygon after the other over an image.
class Painter
{
public:
    explicit Painter(RgbImage& image) : _image(image), _coverage(static_cast<std::size_t>(image.width)) {}

    /// `corners`: in pixels, y down.
    void fill(const std::vector<glm::dvec2>& corners, Colour colour)
    {
        double top = _image.height, bottom = 0.0;
        for (const glm::dvec2 corner : corners)
        {
            top = std::min(top, corner.y);
            bottom = std::max(bottom, corner.y);
        }
        const int first = std::max(static_cast<int>(std::floor(top)), 0);
        const int last = std::min(static_cast<int>(std::floor(bottom)), _image.height - 1);
        for (int row = first; row <= last; ++row)
            fillRow(corners, row, colour);
    }

private:
    void fillRow(const std::vector<glm::dvec2>& corners, int row, Colour colour)
    {
        _from = _image.width;
        _to = 0;
        for (int line = 0; line < kLinesOfRow; ++line)
        {
            findCrossings(corners, row + (line + 0.5) / kLinesOfRow);
            for (std::size_t i = 0; i + 1 < _crossings.size(); i += 2)
                cover(_crossings[i], _crossings[i + 1]);
        }
        for (int x = _from; x < _to; ++x)
            blend(row, x, colour);
    }

    void findCrossings(const std::vector<glm::dvec2>& corners, double y)
    {
        _crossings.clear();
        for (std::size_t i = 0; i < corners.size(); ++i)
        {
            const glm::dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
            if ((a.y <= y) != (b.y <= y)) _crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
        std::sort(_crossings.begin(), _crossings.end());
    }

    /// Adds the share of each pixel that lies between two x.
    void cover(double left, double right)
    {
        left = std::clamp(left, 0.0, static_cast<double>(_image.width));
        right = std::clamp(right, 0.0, static_cast<double>(_image.width));
        const int first = static_cast<int>(left), last = std::min(static_cast<int>(right), _image.width - 1);
        for (int x = first; x <= last; ++x)
        {
            const double share = std::min(right, x + 1.0) - std::max(left, static_cast<double>(x));
            if (share > 0.0) _coverage[static_cast<std::size_t>(x)] += share / kLinesOfRow;
        }
        _from = std::min(_from, first);
        _to = std::max(_to, last + 1);
    }

    void blend(int row, int x, Colour colour)
    {
        double& coverage = _coverage[static_cast<std::size_t>(x)];
        std::uint8_t* const pixel =
            &_image.pixels[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(_image.width) +
                                static_cast<std::size_t>(x))];
        const double share = std::min(coverage, 1.0);
        const std::uint8_t values[] = {colour.red, colour.green, colour.blue};
        for (int i = 0; i < 3; ++i)
            pixel[i] = static_cast<std::uint8_t>(std::lround(pixel[i] + (values[i] - pixel[i]) * share));
        coverage = 0.0;
    }

    RgbImage& _image;
    std::vector<double> _coverage, _crossings;
    int _from = 0, _to = 0; ///< the pixels of a row with coverage
};

} // namespace

RgbImage paintedImage(const TopView& view, int pixels)
{
    const glm::dvec2 size = view.bounds.most - view.bounds.least;
    const double scale = pixels / std::max({size.x, size.y, 1e-3});
    RgbImage image;
    image.width = std::clamp(static_cast<int>(std::ceil(size.x * scale)), 1, pixels);
    image.height = std::clamp(static_cast<int>(std::ceil(size.y * scale)), 1, pixels);
    const Colour ground = view.background;
    for (int i = 0; i < image.width * image.height; ++i)
        image.pixels.insert(image.pixels.end(), {ground.red, ground.green, ground.blue});
    Painter painter(image);
    std::vector<glm::dvec2> corners;
    for (const FilledPolygon& polygon : view.polygons)
    {
        corners.clear();
        for (const glm::dvec2 corner : polygon.corners)
            corners.emplace_back((corner.x - view.bounds.least.x) * scale,
                                 (view.bounds.most.y - corner.y) * scale);
        painter.fill(corners, polygon.colour);
    }
    return image;
}

} // namespace roadtool
