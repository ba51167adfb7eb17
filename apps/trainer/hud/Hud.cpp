// SPDX-License-Identifier: Apache-2.0
#include "hud/Hud.h"

#include <cstdio>

#include <osg/Geometry>

#include "hud/OverlayCamera.h"

namespace trainer
{

namespace
{

const osg::Vec4 kDark(0.0F, 0.0F, 0.0F, 0.45F), kLight(1.0F, 1.0F, 1.0F, 0.9F),
    kAmber(1.0F, 0.75F, 0.1F, 1.0F);
constexpr double kGapPx = 4.0, kPointerPx = 3.0, kLeastHeightPx = 44.0, kMostHeightPx = 84.0;

osg::ref_ptr<osg::MatrixTransform> addPanel(osg::Group& parent, const osg::Vec4& colour)
{
    osg::ref_ptr<osg::MatrixTransform> placed = new osg::MatrixTransform;
    placed->addChild(makeUnitPanel(colour));
    placed->setDataVariance(osg::Object::DYNAMIC);
    parent.addChild(placed);
    return placed;
}

void setRectangle(osg::MatrixTransform& panel, double leftPx, double bottomPx, double widthPx,
                  double heightPx)
{
    panel.setMatrix(osg::Matrixd::scale(widthPx, heightPx, 1.0) *
                    osg::Matrixd::translate(leftPx, bottomPx, 0.0));
}

} // namespace

Hud::Hud(const HudLayout& layout) : _camera(makeOverlayCamera(10))
{
    for (const GaugeKind& kind : layout.gauges)
        addGauge(kind);
    resize(640, 360);
}

void Hud::addGauge(const GaugeKind& kind)
{
    DrawnGauge gauge;
    gauge.kind = kind;
    gauge.scale = {kind.least, kind.most, kind.tick, 1.0};
    gauge.panel = addPanel(*_camera, kDark);
    gauge.line = addPanel(*_camera, kLight);
    const auto ticks = static_cast<int>(std::lround((kind.most - kind.least) / kind.tick));
    for (int i = 0; i <= ticks; ++i)
        gauge.ticks.push_back(addPanel(*_camera, kLight));
    gauge.pointer = addPanel(*_camera, kAmber);
    gauge.label = makeOverlayText(osgText::Text::LEFT_TOP);
    gauge.label->setText(kind.label);
    gauge.number = makeOverlayText(osgText::Text::RIGHT_TOP);
    _camera->addChild(gauge.label);
    _camera->addChild(gauge.number);
    _gauges.push_back(gauge);
    _values.push_back(kind.least);
}

void Hud::place(DrawnGauge& gauge, double leftPx, double widthPx, double heightPx)
{
    const double inside = std::max(widthPx - 4.0 * kGapPx, 1.0), lineY = kGapPx + 0.2 * heightPx;
    gauge.leftPx = std::round(leftPx + 2.0 * kGapPx);
    gauge.scale.lengthPx = std::floor(inside);
    setRectangle(*gauge.panel, leftPx, kGapPx, std::max(widthPx - kGapPx, 1.0), heightPx);
    setRectangle(*gauge.line, gauge.leftPx, lineY, gauge.scale.lengthPx, 1.0);
    for (std::size_t i = 0; i < gauge.ticks.size(); ++i)
    {
        const double x =
            gauge.leftPx + gauge.scale.pointerPx(gauge.kind.least + static_cast<double>(i) * gauge.kind.tick);
        setRectangle(*gauge.ticks[i], x, lineY, 1.0, 0.1 * heightPx);
    }
    _pointerBottomPx = lineY - 0.1 * heightPx;
    _pointerHeightPx = 0.3 * heightPx;
    const auto top = static_cast<float>(kGapPx + 0.94 * heightPx);
    const auto labelPx = static_cast<float>(std::min(0.24 * heightPx, inside / 6.5));
    gauge.label->setCharacterSize(labelPx);
    gauge.label->setPosition({static_cast<float>(gauge.leftPx), top, 0.0F});
    gauge.number->setCharacterSize(static_cast<float>(std::min(0.34 * heightPx, inside / 4.0)));
    gauge.number->setPosition({static_cast<float>(gauge.leftPx + inside), top - 1.1F * labelPx, 0.0F});
}

void Hud::resize(int widthPx, int heightPx)
{
    fitOverlay(*_camera, widthPx, heightPx);
    const double high = std::clamp(heightPx / 6.5, kLeastHeightPx, kMostHeightPx);
    const double wide = std::min((widthPx - 2.0 * kGapPx) / static_cast<double>(_gauges.size()), 2.6 * high);
    const double left = 0.5 * (widthPx - wide * static_cast<double>(_gauges.size()));
    for (std::size_t i = 0; i < _gauges.size(); ++i)
        place(_gauges[i], left + static_cast<double>(i) * wide, wide, high);
    setValues(_values);
}

void Hud::setValues(const std::vector<double>& values)
{
    _values = values;
    for (std::size_t i = 0; i < _gauges.size() && i < values.size(); ++i)
    {
        DrawnGauge& gauge = _gauges[i];
        const double x = gauge.leftPx + gauge.scale.pointerPx(values[i]);
        setRectangle(*gauge.pointer, x - 0.5 * kPointerPx, _pointerBottomPx, kPointerPx, _pointerHeightPx);
        char text[32];
        std::snprintf(text, sizeof text, "%.*f", gauge.kind.decimals, values[i]);
        if (gauge.shown == text) continue;
        gauge.shown = text;
        gauge.number->setText(gauge.shown);
    }
}

} // namespace trainer
