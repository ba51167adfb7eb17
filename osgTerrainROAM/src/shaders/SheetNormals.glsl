// SPDX-License-Identifier: Apache-2.0
// Takes normals from the maps of denser sheets: sheetTilt() replaces x and y of the normal at `grid`, and the weights of the
// bumps that the sheet's data do not show themselves. RepeatedLayers.cpp replaces the lines <...>.

// <uniforms>

// A sheet fades over its last cell into the layer below, as its heights do.
void addSheet(inout vec2 tilt, inout vec4 bumpiness, sampler2D normals, vec4 fromGrid, vec4 rect, vec4 bumps)
{
    vec2 inward = min(grid - rect.xy, rect.zw - grid) / sheetCell;
    vec2 here = texture(normals, grid * fromGrid.xy + fromGrid.zw).rg * 2.0 - 1.0; // unconditional: mip level
    float share = smoothstep(0.0, 1.0, min(inward.x, inward.y));
    tilt = mix(tilt, here, share);
    bumpiness = mix(bumpiness, bumps, share);
}

void sheetTilt(inout vec2 tilt, inout vec4 bumpiness)
{
    // <sheets>
}
