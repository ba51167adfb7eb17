// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/Camera>
#include <osg/MatrixTransform>
#include <osgText/Text>

#include "hud/HudReadings.h"

namespace trainer
{

/// The head-up display: gauges in a row along the lower edge of the picture, each a number and a pointer on a
/// scale.
/// Frame: pixels from the lower left corner. Threads: the update phase.
class Hud
{
public:
    explicit Hud(const HudLayout& layout);

    osg::Camera* camera() const { return _camera; }
    void resize(int widthPx, int heightPx);
    void show(bool isShown) { _camera->setNodeMask(isShown ? ~0U : 0U); }
    bool isShown() const { return _camera->getNodeMask() != 0U; }

    /// `values`: as many as gauges, in their order and units.
    void setValues(const std::vector<double>& values);

    /// For tests: the scale of a gauge, and where its pointer and its left end are drawn.
    const GaugeScale& scale(std::size_t gauge) const { return _gauges[gauge].scale; }
    double pointerPx(std::size_t gauge) const
    {
        return _gauges[gauge].pointer->getMatrix().getTrans().x() + 1.5;
    } ///< its middle
    double leftPx(std::size_t gauge) const { return _gauges[gauge].leftPx; }

private:
    struct DrawnGauge
    {
        GaugeKind kind;
        GaugeScale scale;
        double leftPx = 0.0;
        osg::ref_ptr<osg::MatrixTransform> panel, line, pointer;
        std::vector<osg::ref_ptr<osg::MatrixTransform>> ticks;
        osg::ref_ptr<osgText::Text> label, number;
        std::string shown;
    };

    void addGauge(const GaugeKind& kind);
    void place(DrawnGauge& gauge, double leftPx, double widthPx, double heightPx);

    osg::ref_ptr<osg::Camera> _camera;
    std::vector<DrawnGauge> _gauges;
    std::vector<double> _values;
    double _pointerBottomPx = 0.0, _pointerHeightPx = 1.0;
};

} // namespace trainer
