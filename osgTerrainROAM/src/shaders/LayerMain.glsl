// SPDX-License-Identifier: Apache-2.0
// Shades a fragment of a tile of osgTerrain: light, colour layers, fog. LayerShader.cpp replaces the line <...> by the
// layers, in the order of their units.

void main()
{
    vec4 surface = surfaceAt(grid * terrainSurfaceFromGrid.xy + terrainSurfaceFromGrid.zw);
    vec3 place = terrainEyeFromLocal * fromEye;
    vec2 uv = grid / terrainLastSample;
    vec4 weights = vec4(1.0, uv, uv.x * uv.y);
    vec4 colour = lit(normalize(terrainEyeFromLocal * (surface.xyz * 2.0 - 1.0)), place);
    // <layers>
    gl_FragColor = vec4(fogged(colour.rgb, -place.z), colour.a);
}
