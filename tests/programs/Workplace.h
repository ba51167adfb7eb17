// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "RasterWriter.h"
#include "ScenarioText.h"

/// A temporary folder in which the programs find a small terrain and leave what they make.
class Workplace
{
public:
    /// Writes hill.tif, a hill of 200 m on 65² samples 30 m apart.
    Workplace();

    std::string hill() const { return path("hill.tif"); }
    std::string path(const std::string& name) const { return (_folder / name).string(); }

    /// Writes a text and returns its path.
    std::string write(const std::string& name, const std::string& text) const;

    /// The hill again, with its top sample raised, in a zone of UTM by its code: 32632 is in Italy.
    std::string writeHill(const std::string& name, double raisedM, int epsg = 32632) const;

    /// Everything below the folder, sorted: to see that nothing was left there.
    std::vector<std::string> files() const;

private:
    TemporaryFolder _folder;
};

/// A scenario of a quarter of a second: a car drives over the terrain `scene`, which stands as it is written.
std::string driveText(const std::string& scene);

/// `text` with `replaced` exchanged once; a failed test when it is not there.
std::string with(std::string text, const std::string& replaced, const std::string& by);
