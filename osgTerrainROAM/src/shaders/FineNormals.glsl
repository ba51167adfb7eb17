// SPDX-License-Identifier: Apache-2.0
// Takes normals from the pages of edited cells (FineNormals.h): fineTilt() replaces x and y of the normal at `grid`, and tells the
// share of edited ground there.

uniform sampler2D terrainFineIndex; // per cell of the raster: 1 + page, or 0
uniform sampler2DArray terrainFineNormals; // x and y of the normal times its weight, the weight
uniform float terrainCellsPerPlace; // cells of the raster per grid unit

vec2 fineTilt(vec2 tilt, out float edited)
{
    edited = 0.0;
    vec2 cells = grid * terrainCellsPerPlace;
    vec2 alongX = dFdx(cells);
    vec2 alongY = dFdy(cells);
    float page = floor(texelFetch(terrainFineIndex, ivec2(cells), 0).r * 65535.0 + 0.5);
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = page < 1.0 ? 1 : 0; i < 1; ++i)
    {
        vec3 fine = textureGrad(terrainFineNormals, vec3(fract(cells), page - 1.0), alongX, alongY).rgb;
        edited = fine.b;
        tilt = tilt * (1.0 - fine.b) + fine.rg * 2.0 - 1.0;
    }
    return tilt;
}
