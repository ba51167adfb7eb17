// SPDX-License-Identifier: Apache-2.0
// Defines pmAlpha(), the alpha of an object on its way between two levels: blended, or by a screen door. Source of the
// door's ordered pattern: Bayer, An optimum method for two-level rendition of continuous-tone pictures (1973).

#pragma import_defines ( OSGPM_SWITCHED, OSGPM_BLENDED )

#ifdef OSGPM_SWITCHED
flat in vec2 pmDoor;
#ifdef OSGPM_BLENDED
float pmAlpha() { return pmDoor.y - pmDoor.x; }
#else
// The rank of a pixel in the 8 x 8 pattern, 0 ... 1: its bits come from the coarsest grid first.
float pmPixelOrder()
{
    int x = int(gl_FragCoord.x) & 7;
    int y = int(gl_FragCoord.y) & 7;
    int d = x ^ y;
    int order = (d & 1) << 5 | (y & 1) << 4 | (d & 2) << 2 | (y & 2) << 1 | (d & 4) >> 1 | (y & 4) >> 2;
    return (float(order) + 0.5) / 64.0;
}
float pmAlpha()
{
    float order = pmPixelOrder();
    if (order < pmDoor.x || order >= pmDoor.y) discard;
    return 1.0;
}
#endif
#else
float pmAlpha() { return 1.0; }
#endif
