// SPDX-License-Identifier: Apache-2.0
#include "Workplace.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace
{

constexpr int kSide = 65, kMiddle = 32;

/// In file order; rough enough that most samples count.
std::vector<double> hillHeights(double raisedM)
{
    std::vector<double> heights;
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column)
        {
            const double x = column - kMiddle, y = row - kMiddle;
            heights.push_back(300.0 + 200.0 * std::exp(-(x * x + y * y) / 200.0) +
                              5.0 * std::sin(1.3 * column) * std::cos(row));
        }
    heights[kMiddle * kSide + kMiddle] += raisedM;
    return heights;
}

} // namespace

Workplace::Workplace()
{
    writeHill("hill.tif", 0.0);
}

std::string Workplace::writeHill(const std::string& name, double raisedM, int epsg) const
{
    RasterSpec spec;
    spec.columns = spec.rows = kSide;
    spec.values = hillHeights(raisedM);
    spec.geoTransform = {436000.0, 30.0, 0.0, 4829950.0, 0.0, -30.0};
    spec.epsg = epsg;
    writeRaster(_folder / name, "GTiff", spec);
    return path(name);
}

std::string Workplace::write(const std::string& name, const std::string& text) const
{
    writeBytes(_folder / name, text);
    return path(name);
}

std::vector<std::string> Workplace::files() const
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(_folder.path()))
        names.push_back(std::filesystem::relative(entry.path(), _folder.path()).string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string driveText(const std::string& scene)
{
    simulation::ScenarioText text;
    text.privates = "\n" + simulation::teleport("<WorldPosition x=\"-600\" y=\"0\"/>") + "\n" +
                    simulation::speedAction(15.0);
    text.stop = simulation::stopAt(0.25);
    return with(text.text(), "<RoadNetwork/>",
                "<RoadNetwork><SceneGraphFile filepath=\"" + scene + "\"/></RoadNetwork>");
}

std::string with(std::string text, const std::string& replaced, const std::string& by)
{
    const std::size_t at = text.find(replaced);
    if (at == std::string::npos)
        ADD_FAILURE() << "there is no '" << replaced << "' in:\n" << text;
    else
        text.replace(at, replaced.size(), by);
    return text;
}
