// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osg/Camera>
#include <osg/MatrixTransform>
#include <osgText/Text>

#include "input/KeyTable.h"

namespace trainer
{

/// Text over the picture of a window: a message, the help, statistics. It draws after everything else, in
/// pixels from the lower left corner.
/// Threads: the update phase.
class TextOverlay
{
public:
    TextOverlay();

    osg::Camera* camera() const { return _camera; }

    /// The size of the window; text is as large as it allows.
    void resize(int widthPx, int heightPx);

    /// The top line: what the play is about; empty: none.
    void setMessage(const std::string& text);

    /// Every key of the table for such a vehicle.
    void showHelp(KeyScope vehicle, bool isShown);
    bool isHelpShown() const { return _isHelpShown; }

    /// An arrow in the middle: the ownship on a map. `headingDeg`: counter-clockwise from the right.
    void showMark(bool isShown, double headingDeg);

    void showStatistics(bool isShown);
    bool areStatisticsShown() const { return _areStatisticsShown; }
    void setStatistics(const std::string& text);

private:
    osg::ref_ptr<osgText::Text> addText(osgText::Text::AlignmentType alignment);
    void place();

    osg::ref_ptr<osg::Camera> _camera;
    osg::ref_ptr<osg::MatrixTransform> _panel, _mark; ///< behind the help; on the map
    osg::ref_ptr<osgText::Text> _message, _help, _helpRight, _statistics;
    int _widthPx = 1, _heightPx = 1;
    std::size_t _helpLines = 1;
    bool _isHelpShown = false, _areStatisticsShown = false;
};

/// The help as lines "key  text".
std::vector<std::string> helpLines(KeyScope vehicle);

} // namespace trainer
