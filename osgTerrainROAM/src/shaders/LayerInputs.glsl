// SPDX-License-Identifier: Apache-2.0
// Declares the inputs and uniforms of the fragment shader for tiles of osgTerrain (LayerShader.h).

in vec3 fromEye; // metres, the tile's frame
in vec2 grid; // samples
uniform mat3 terrainEyeFromLocal;
uniform vec2 terrainLastSample;
uniform sampler2D terrainSurface; // SurfaceMap.h
uniform vec4 terrainSurfaceFromGrid;
uniform vec2 terrainLayerHeights;
uniform vec4 terrainLayerS[8];
uniform vec4 terrainLayerT[8];
uniform int terrainLights; // one bit for each light that is on; below 0: no lighting
uniform int terrainLightCount; // one more than the last light that is on, at least 1
uniform vec4 terrainFog;       // FixedFunction.h
