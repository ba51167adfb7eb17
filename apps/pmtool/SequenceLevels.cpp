// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <utility>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/polish/PolishByImages.h>
#include <osgPMObjects/core/selection/ContinuousRule.h>
#include <osgPMObjects/core/simplify/ToleranceSearch.h>

#include <osgPMObjects/MaterialLooks>

#include "pmtool/LevelMaker.h"
#include "pmtool/Timing.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Json = nlohmann::ordered_json;

class SequenceLevels : public LevelMaker
{
public:
    SequenceLevels(const ImportedModel& model, const core::SimplifySettings& settings, bool arePolished,
                   double speckSize)
        : _model(model), _settings(settings), _arePolished(arePolished), _errors(model.mesh, speckSize)
    {
        _settings.materialColours = materialColours(model.mesh, model.states);
        _ms = millisecondsOf([this] { _sequence = core::simplify(_model.mesh, _settings); });
        _search.emplace(_model.mesh, _sequence, _errors.meter());
    }

    SequenceLevels(const ImportedModel& model, const RemovalRequest& removal, double speckSize)
        : _model(model), _errors(model.mesh, speckSize)
    {
        _ms = millisecondsOf([&] { _sequence = removalsOf(model.mesh, removal); });
        _search.emplace(_model.mesh, _sequence, _errors.meter());
    }

    Json summary() const override
    {
        return {
            {"least", _sequence.steps.empty() ? _sequence.facesBefore : _sequence.steps.back().facesAfter},
            {"ms", _ms}};
    }

    foundation::Result<MadeLevel> make(const LevelWish& wish) override
    {
        if (!_arePolished) return levelOf(_sequence, wish);
        foundation::Result<MadeLevel> level = MadeLevel();
        const double ms = millisecondsOf(
            [&]
            {
                const auto looks = materialLooks(_model.mesh, _model.states);
                const core::PolishSettings polish{.simplify = _settings};
                level = levelOf(
                    core::polishByImages(_model.mesh, _sequence, wish.faces.value(), looks, polish), wish);
            });
        level->row["ms"] = ms;
        return level;
    }

private:
    MadeLevel levelOf(const core::CollapseSequence& sequence, const LevelWish& wish)
    {
        const std::size_t steps = stepsTo(sequence, wish);
        const core::LevelError error = steps > 0 ? sequence.steps[steps - 1].error : core::LevelError();
        MadeLevel level{
            core::meshAfter(_model.mesh, sequence, steps),
            {{"level", wish.name},
             {"triangles", steps > 0 ? sequence.steps[steps - 1].facesAfter : sequence.facesBefore},
             {"distance", error.distance},
             {"normal", error.normal},
             {"texCoord", error.texCoord},
             {"colour", error.colour}}};
        if (wish.farther)
            level.row["trianglesByFormula"] = sequence.facesBefore / (*wish.farther * *wish.farther);
        _errors.addTo(level, wish);
        return level;
    }

    /// Returns the steps to a level; a distance gives the number T of vertices that the continuous rule
    /// removes.
    std::size_t stepsTo(const core::CollapseSequence& sequence, const LevelWish& wish)
    {
        if (wish.faces) return core::stepsToFaces(sequence, *wish.faces);
        if (!wish.farther) return _search->coarsestWithin(wish.tolerance);
        const core::MeshCounts counts = core::countMesh(_model.mesh);
        return core::removalAt(1.0, *wish.farther, static_cast<std::uint32_t>(counts.positions),
                               static_cast<std::uint32_t>(sequence.steps.size()))
            .steps;
    }

    const ImportedModel& _model;
    core::SimplifySettings _settings;
    bool _arePolished = false;
    LevelErrors _errors;
    core::CollapseSequence _sequence;
    std::optional<core::ToleranceSearch> _search; ///< of `_sequence`, which must not move
    double _ms = 0.0;
};

} // namespace

std::unique_ptr<LevelMaker> sequenceLevels(const ImportedModel& model, const core::SimplifySettings& settings,
                                           bool arePolished, double speckSize)
{
    return std::make_unique<SequenceLevels>(model, settings, arePolished, speckSize);
}

std::unique_ptr<LevelMaker> removalLevels(const ImportedModel& model, const RemovalRequest& request,
                                          double speckSize)
{
    return std::make_unique<SequenceLevels>(model, request, speckSize);
}

} // namespace pmtool
