// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include <osgPMObjects/core/simplify/LevelMeter.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include <osgPMObjects/ImportNode>

#include "pmtool/RemovalOptions.h"

namespace pmtool
{

/// How `pmtool simplify` makes levels.
enum class SimplifyMethod
{
    edges,    ///< edge collapses by quadrics: simplify()
    clusters, ///< one vertex for each cube of a grid: clusterVertices()
    images,   ///< edge collapses, the last ones chosen by images: polishByImages()
    removal,  ///< one vertex a step, holes filled by fans: removeVertices()
};

/// A level that was asked for: by its number of faces, by its distance from the eye, or else by its largest
/// measured distance from the original.
struct LevelWish
{
    std::string name; ///< in the file's name: "25pc", "0.1m", "8x"
    std::optional<std::size_t> faces;
    double tolerance = 0.0;                       ///< units of the model
    std::optional<double> farther = std::nullopt; ///< times the distance at which all faces are drawn
};

/// A level that was made, and its row in the table; docs/reference/json-tables.md has the keys.
struct MadeLevel
{
    osgPMObjects::core::Mesh mesh;
    nlohmann::ordered_json row;
};

/// Makes the levels of one model by one method. The model must outlive it.
class LevelMaker
{
public:
    virtual ~LevelMaker() = default;

    /// Figures of all levels together: "least" faces that can be reached, "ms" that were spent before the
    /// first level.
    virtual nlohmann::ordered_json summary() const = 0;
    virtual foundation::Result<MadeLevel> make(const LevelWish& wish) = 0;
};

/// Measures the levels of one model, and adds the figures to their rows.
class LevelErrors
{
public:
    /// The number of points spread by area on each surface.
    static constexpr std::size_t kSamples = 60'000;

    /// `speckSize`: as of LevelMeter.
    LevelErrors(const osgPMObjects::core::Mesh& original, double speckSize)
        : _meter(original, kSamples, speckSize), _hasSpecks(speckSize > 0.0)
    {
    }

    const osgPMObjects::core::LevelMeter& meter() const { return _meter; }

    /// Adds "errorMax" and "errorRms"; with specks "specksVanished": those farther from the level than the
    /// tolerance, or than errorMax where there is none.
    void addTo(MadeLevel& level, const LevelWish& wish) const;

private:
    osgPMObjects::core::LevelMeter _meter;
    bool _hasSpecks;
};

/// edges and images. Both run simplify() at once. Of images a wish must have `faces`. `speckSize`: as of
/// LevelErrors.
std::unique_ptr<LevelMaker> sequenceLevels(const osgPMObjects::ImportedModel& model,
                                           const osgPMObjects::core::SimplifySettings& settings,
                                           bool arePolished, double speckSize);

/// removal, likewise.
std::unique_ptr<LevelMaker> removalLevels(const osgPMObjects::ImportedModel& model,
                                          const RemovalRequest& request, double speckSize);

/// clusters. Errors of make(): no cells of a size that the tolerance asks for. `speckSize`: as of
/// LevelErrors.
std::unique_ptr<LevelMaker> clusterLevels(const osgPMObjects::core::Mesh& mesh, double speckSize);

} // namespace pmtool
