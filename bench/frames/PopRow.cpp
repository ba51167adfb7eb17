// SPDX-License-Identifier: Apache-2.0
#include "PopRow.h"

#include <cstdio>
#include <sstream>

#include "StaticMesh.h"

namespace framebench
{

namespace
{

/// The factor of the tolerance in the coarse frame, a change that the measurement has to detect.
constexpr double kCoarser = 10.0;

constexpr std::string_view followingName(Following following)
{
    constexpr std::string_view kNames[] = {"switching", "morphing", "frozen"};
    return kNames[static_cast<int>(following)];
}

Report levels(const LevelHistogram& histogram)
{
    Report json;
    json["p50"] = histogram.percentile(0.5);
    json["p99"] = histogram.percentile(0.99);
    json["p999"] = histogram.percentile(0.999);
    json["max"] = histogram.percentile(1.0);
    json["shareAbove2"] = histogram.shareAbove(2);
    return json;
}

} // namespace

PopRow::PopRow(const Request& request, Stage& stage, Setting setting)
    : _request(request),
      _stage(stage),
      _setting(std::move(setting)),
      _state(lookState(*request.material, _setting.look)),
      _drawable(new osgTerrainROAM::RoamDrawable(request.tile)),
      _mesh(request.tile)
{
    (void)_drawable->setMorphing(_setting.following == Following::morphing);
    _mesh.setMorphing(_setting.following == Following::morphing);
    if (_setting.following != Following::frozen) return;
    refine(request.frames / 2);
    _frozen = staticMesh(_mesh.drawn());
}

bool PopRow::measuresPop() const
{
    // With four samples along an axis a picture takes seconds, and two show the popping as well.
    return _setting.following != Following::frozen && _setting.samplesPerPx <= 2;
}

void PopRow::refine(int frame)
{
    const double coarser = frame == _request.coarseFrame ? kCoarser : 1.0;
    const double tolerancePx = _setting.tolerancePx * _setting.samplesPerPx * coarser;
    if (const auto set = _drawable->setErrorTolerancePx(tolerancePx); !set)
        std::fprintf(stderr, "%s\n", set.error().message().c_str());
    const Eye eye = _request.eye(frame);
    const auto view = viewlod::ViewState::fromMatrices(eye.view, eye.projection, _stage.settings().widthPx,
                                                       _stage.settings().heightPx);
    _mesh.refine(view, {.errorTolerancePx = tolerancePx});
}

Picture PopRow::drawn(osg::Node* node, int frame)
{
    _stage.show(node, _state);
    return boxFiltered(*_stage.picture(_request.eye(frame)), _setting.samplesPerPx);
}

foundation::Outcome PopRow::frame(int frame, const Picture& full, const std::vector<bool>& edges)
{
    std::optional<Picture> pop;
    if (_before && measuresPop()) pop = drawn(staticMesh(_mesh.drawn()), frame);
    if (!_frozen) refine(frame);
    const Picture lod = drawn(_frozen ? static_cast<osg::Node*>(_frozen) : _drawable, frame);
    if (pop) pop = difference(lod, *pop);

    Picture apart = difference(lod, full);
    foundation::Outcome kept = foundation::success();
    if (_before)
    {
        const Picture delta = difference(apart, *_before);
        count(delta, pop ? &*pop : nullptr, edges);
        if (frame == _request.pictureFrame) kept = keep(lod, full, delta);
    }
    for (const int v : apart.values)
        _counts.difference.add(v);
    _before = std::move(apart);
    return kept;
}

void PopRow::count(const Picture& delta, const Picture* pop, const std::vector<bool>& edges)
{
    for (std::size_t i = 0; i < delta.values.size(); ++i)
    {
        const bool isEdge = edges[i / 3];
        _counts.delta.add(delta.values[i]);
        (isEdge ? _counts.deltaAtEdges : _counts.deltaInside).add(delta.values[i]);
        if (!pop) continue;
        _counts.pop.add(pop->values[i]);
        if (!isEdge) _counts.popInside.add(pop->values[i]);
    }
}

foundation::Outcome PopRow::keep(const Picture& lod, const Picture& full, const Picture& delta) const
{
    constexpr int kGain = 16;
    std::ostringstream stem;
    stem << lookName(_setting.look) << '-' << _setting.antialiasing << '-' << _setting.tolerancePx << "px-"
         << followingName(_setting.following) << '-';
    for (const auto& [what, picture, gain] : {std::tuple{"lod", lod, 1},
                                              {"full", full, 1},
                                              {"apart", difference(lod, full), kGain},
                                              {"delta", delta, kGain}})
    {
        const auto file = _request.pictureFolder / (stem.str() + what + ".png");
        if (const auto done = writePicture(picture, gain, file); !done) return done.error();
    }
    return foundation::success();
}

Report PopRow::json() const
{
    const auto values = static_cast<double>(std::max<std::uint64_t>(_counts.delta.total(), 1));
    Report row;
    row["look"] = lookName(_setting.look);
    row["antialiasing"] = _setting.antialiasing;
    row["tolerancePx"] = _setting.tolerancePx;
    row["mesh"] = followingName(_setting.following);
    row["edgeShare"] = static_cast<double>(_counts.deltaAtEdges.total()) / values;
    row["lodMinusFull"] = levels(_counts.difference);
    row["delta"] = levels(_counts.delta);
    row["deltaAtEdges"] = levels(_counts.deltaAtEdges);
    row["deltaInside"] = levels(_counts.deltaInside);
    if (!measuresPop()) return row;
    row["pop"] = levels(_counts.pop);
    row["popInside"] = levels(_counts.popInside);
    return row;
}

} // namespace framebench
