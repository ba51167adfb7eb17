// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "roadtool/TopView.h"

namespace roadtool
{

/// Each adds the polygons of one part of a usable road. Strips have corners at least `shortestM` apart, where
/// that is more than the error of chords asks for.
void paintLanes(const osgRoads::core::Road& road, double shortestM, std::vector<FilledPolygon>& polygons);
void paintMarks(const osgRoads::core::Road& road, double shortestM, std::vector<FilledPolygon>& polygons);

/// Objects and signals.
void paintObjects(const osgRoads::core::Road& road, double shortestM, std::vector<FilledPolygon>& polygons);

} // namespace roadtool
