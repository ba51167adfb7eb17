// SPDX-License-Identifier: Apache-2.0
#include "PopRow.h"

#include "StaticMesh.h"

namespace framebench
{

namespace
{

/// The coarse frame's share of the detail: what the measure has to see.
constexpr double kCoarser = 10.0;

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

PopRow::PopRow(const Request& request, Look look, double tolerancePx, bool morphing, int samplesPerPx)
    : _look(look),
      _tolerancePx(tolerancePx),
      _morphing(morphing),
      _samplesPerPx(samplesPerPx),
      _state(lookState(*request.material, look)),
      _drawable(new osgTerrainROAM::RoamDrawable(request.tile)),
      _mesh(request.tile)
{
    _drawable->setMorphing(morphing);
    _mesh.setMorphing(morphing);
}

viewlod::Outcome PopRow::frame(const Request& request, Stage& stage, int frame, const Picture& full,
                               const std::vector<bool>& edges, const std::string& antialiasing)
{
    const Eye eye = request.eye(frame);
    std::optional<Picture> late;
    if (_before)
    {
        stage.show(staticMesh(_mesh.drawn()), _state);
        late = boxFiltered(*stage.picture(eye), _samplesPerPx);
    }

    const double tolerancePx = _tolerancePx * _samplesPerPx * (frame == request.coarseFrame ? kCoarser : 1.0);
    const auto view = viewlod::ViewState::fromMatrices(eye.view, eye.projection, stage.settings().widthPx,
                                                       stage.settings().heightPx);
    _mesh.refine(view, {.errorTolerancePx = tolerancePx});
    _drawable->setErrorTolerancePx(tolerancePx);
    stage.show(_drawable, _state);
    const Picture lod = boxFiltered(*stage.picture(eye), _samplesPerPx);
    _triangles += _drawable->statistics().front().trianglesDrawn;
    ++_frames;

    Picture apart = difference(lod, full);
    viewlod::Outcome kept = viewlod::success();
    if (_before)
    {
        const Picture delta = difference(apart, *_before);
        count(delta, difference(lod, *late), edges);
        if (frame == request.pictureFrame) kept = keep(request, antialiasing, lod, full, delta);
    }
    for (const int v : apart.values)
        _difference.add(v);
    _before = std::move(apart);
    return kept;
}

void PopRow::count(const Picture& delta, const Picture& pop, const std::vector<bool>& edges)
{
    for (std::size_t i = 0; i < delta.values.size(); ++i)
    {
        const bool isEdge = edges[i / 3];
        _delta.add(delta.values[i]);
        (isEdge ? _deltaAtEdges : _deltaInside).add(delta.values[i]);
        _pop.add(pop.values[i]);
        if (!isEdge) _popInside.add(pop.values[i]);
    }
}

viewlod::Outcome PopRow::keep(const Request& request, const std::string& antialiasing, const Picture& lod,
                              const Picture& full, const Picture& delta) const
{
    constexpr int kGain = 16;
    const std::string stem = std::string(lookName(_look)) + "-" + antialiasing + "-" +
                             std::to_string(_tolerancePx).substr(0, 4) + "px" +
                             (_morphing ? "-morphing" : "");
    const auto file = [&](const char* what) { return request.pictureFolder / (stem + "-" + what + ".png"); };
    for (const auto& [what, picture, gain] : {std::tuple{"lod", lod, 1},
                                              {"full", full, 1},
                                              {"apart", difference(lod, full), kGain},
                                              {"delta", delta, kGain}})
        if (const auto done = writePicture(picture, gain, file(what)); !done) return done.error();
    return viewlod::success();
}

Report PopRow::json(const std::string& antialiasing) const
{
    Report row;
    row["look"] = lookName(_look);
    row["antialiasing"] = antialiasing;
    row["tolerancePx"] = _tolerancePx;
    row["morphing"] = _morphing;
    row["triangles"] = _triangles / std::max(_frames, 1);
    row["edgeShare"] = static_cast<double>(_deltaAtEdges.total()) /
                       static_cast<double>(std::max<std::uint64_t>(_delta.total(), 1));
    row["lodMinusFull"] = levels(_difference);
    row["delta"] = levels(_delta);
    row["deltaAtEdges"] = levels(_deltaAtEdges);
    row["deltaInside"] = levels(_deltaInside);
    row["pop"] = levels(_pop);
    row["popInside"] = levels(_popInside);
    return row;
}

} // namespace framebench
