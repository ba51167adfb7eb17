// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include <osgPMObjects/core/polish/PolishByImages.h>
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
        _ms = millisecondsOf([this] { _sequence = core::simplify(_model.mesh, _settings); });
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
        const std::size_t steps =
            wish.faces ? core::stepsToFaces(sequence, *wish.faces) : _search->coarsestWithin(wish.tolerance);
        const core::LevelError error = steps > 0 ? sequence.steps[steps - 1].error : core::LevelError();
        MadeLevel level{
            core::meshAfter(_model.mesh, sequence, steps),
            {{"level", wish.name},
             {"triangles", steps > 0 ? sequence.steps[steps - 1].facesAfter : sequence.facesBefore},
             {"distance", error.distance},
             {"normal", error.normal},
             {"texCoord", error.texCoord},
             {"colour", error.colour}}};
        _errors.addTo(level, wish);
        return level;
    }

    const ImportedModel& _model;
    core::SimplifySettings _settings;
    bool _arePolished;
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

} // namespace pmtool
