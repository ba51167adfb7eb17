// SPDX-License-Identifier: Apache-2.0
#include "hud/TextOverlay.h"

#include <algorithm>

#include <osg/Geometry>

#include "hud/OverlayCamera.h"

namespace trainer
{

namespace
{

constexpr float kMarginPx = 10.0F;
constexpr float kSmallestPx = 9.0F, kLargestPx = 20.0F;
constexpr float kHelpShare = 0.9F; ///< of the height that the help may take

/// Lines of text, one below the other.
std::string joined(std::vector<std::string>::const_iterator from, std::vector<std::string>::const_iterator to)
{
    std::string text;
    for (; from != to; ++from)
        text += *from + "\n";
    return text;
}

/// Points to the right; half as wide as long.
osg::ref_ptr<osg::Geometry> makeArrow()
{
    osg::ref_ptr<osg::Geometry> arrow = makeUnitPanel({1.0F, 0.2F, 0.1F, 1.0F});
    const osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const auto& corner : {osg::Vec3(1.0F, 0.0F, 0.0F), osg::Vec3(-0.8F, 0.6F, 0.0F),
                               osg::Vec3(-0.4F, 0.0F, 0.0F), osg::Vec3(-0.8F, -0.6F, 0.0F)})
        corners->push_back(corner);
    arrow->setVertexArray(corners);
    return arrow;
}

} // namespace

std::vector<std::string> helpLines(KeyScope vehicle)
{
    std::size_t longest = 0;
    for (const KeyBinding& binding : keyTable())
        longest = std::max(longest, binding.key.size());
    std::vector<std::string> lines;
    for (const KeyBinding& binding : keyTable())
    {
        if (!isFor(binding, vehicle)) continue;
        std::string line(binding.key);
        line.resize(longest + 2, ' ');
        lines.push_back(line + std::string(binding.text));
    }
    return lines;
}

TextOverlay::TextOverlay() : _camera(makeOverlayCamera(20))
{
    _panel = new osg::MatrixTransform;
    _panel->addChild(makeUnitPanel({0.0F, 0.0F, 0.0F, 0.6F}));
    _panel->setDataVariance(osg::Object::DYNAMIC);
    _camera->addChild(_panel);
    _mark = new osg::MatrixTransform;
    _mark->addChild(makeArrow());
    _mark->setDataVariance(osg::Object::DYNAMIC);
    _mark->setNodeMask(0U);
    _camera->addChild(_mark);
    _message = addText(osgText::Text::CENTER_TOP);
    _help = addText(osgText::Text::LEFT_TOP);
    _helpRight = addText(osgText::Text::LEFT_TOP);
    _statistics = addText(osgText::Text::LEFT_TOP);
    showHelp(KeyScope::all, false);
    showStatistics(false);
}

osg::ref_ptr<osgText::Text> TextOverlay::addText(osgText::Text::AlignmentType alignment)
{
    osg::ref_ptr<osgText::Text> text = makeOverlayText(alignment);
    _camera->addChild(text);
    return text;
}

void TextOverlay::resize(int widthPx, int heightPx)
{
    _widthPx = std::max(widthPx, 1);
    _heightPx = std::max(heightPx, 1);
    fitOverlay(*_camera, _widthPx, _heightPx);
    place();
}

void TextOverlay::place()
{
    const float high = static_cast<float>(_heightPx), wide = static_cast<float>(_widthPx);
    const float usual = std::clamp(high / 30.0F, kSmallestPx, kLargestPx);
    const float help = std::clamp(kHelpShare * high / (1.15F * static_cast<float>(_helpLines)), 6.0F, usual);
    _panel->setMatrix(osg::Matrixd::scale(0.98 * wide, 0.98 * high, 1.0) *
                      osg::Matrixd::translate(0.01 * wide, 0.01 * high, 0.0));
    _message->setCharacterSize(usual);
    _message->setPosition({0.5F * wide, high - kMarginPx, 0.0F});
    _statistics->setCharacterSize(usual);
    _statistics->setPosition({kMarginPx, high - kMarginPx - 1.6F * usual, 0.0F});
    _help->setCharacterSize(help);
    _help->setPosition({0.04F * wide, 0.95F * high, 0.0F});
    _helpRight->setCharacterSize(help);
    _helpRight->setPosition({0.52F * wide, 0.95F * high, 0.0F});
}

void TextOverlay::setMessage(const std::string& text)
{
    _message->setText(text);
}

void TextOverlay::showHelp(KeyScope vehicle, bool isShown)
{
    _isHelpShown = isShown;
    const std::vector<std::string> lines = helpLines(vehicle);
    const auto half = static_cast<std::ptrdiff_t>((lines.size() + 1) / 2);
    _helpLines = static_cast<std::size_t>(half);
    _help->setText(joined(lines.begin(), lines.begin() + half));
    _helpRight->setText(joined(lines.begin() + half, lines.end()));
    const unsigned mask = isShown ? ~0U : 0U;
    _help->setNodeMask(mask);
    _helpRight->setNodeMask(mask);
    _panel->setNodeMask(mask);
    for (const auto& text : {_message, _statistics})
        text->setNodeMask(~mask);
    if (!_areStatisticsShown) _statistics->setNodeMask(0U);
    place();
}

void TextOverlay::showMark(bool isShown, double headingDeg)
{
    const double sizePx = std::max(7.0, 0.025 * _heightPx);
    _mark->setNodeMask(isShown && !_isHelpShown ? ~0U : 0U);
    _mark->setMatrix(osg::Matrixd::scale(sizePx, sizePx, 1.0) *
                     osg::Matrixd::rotate(osg::DegreesToRadians(headingDeg), osg::Vec3d(0.0, 0.0, 1.0)) *
                     osg::Matrixd::translate(0.5 * _widthPx, 0.5 * _heightPx, 0.0));
}

void TextOverlay::showStatistics(bool isShown)
{
    _areStatisticsShown = isShown;
    _statistics->setNodeMask(isShown && !_isHelpShown ? ~0U : 0U);
}

void TextOverlay::setStatistics(const std::string& text)
{
    _statistics->setText(text);
}

} // namespace trainer
