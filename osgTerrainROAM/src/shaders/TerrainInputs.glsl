// SPDX-License-Identifier: Apache-2.0
// Declares the inputs and uniforms of the terrain's fragment shader. TerrainMaterial sets them; those of the eye come from
// ViewPart.

in vec3 fromEye; // metres, the tile's frame
in vec2 grid; // samples
uniform sampler2D terrainNormals; // NormalMap.h
uniform sampler2D terrainLand; // LandMap.h
uniform sampler2D terrainGrain; // GrainImage.h
uniform sampler2D terrainDrape;
uniform vec4 terrainMapFromGrid;
uniform vec4 terrainBend; // by how many texels each layer of the grain bends the lookups of the maps
uniform vec2 terrainBroad; // periods of the broadest layer of grain per grid unit
uniform vec4 terrainDrapeFromGrid;
uniform vec3 terrainEyeWrapped; // the eye's position modulo 4096 m
#if defined(TERRAIN_FEATURES) || defined(TERRAIN_SEASON) || defined(TERRAIN_OPENINGS)
uniform ivec3 terrainEyeWraps; // the number of whole 4096 m that terrainEyeWrapped leaves out
#endif
uniform mat3 terrainWorldFromLocal;
uniform vec4 terrainBumpiness;
uniform vec3 terrainRock;
uniform vec3 terrainSoil;
uniform vec3 terrainDryGrass;
uniform vec3 terrainMeadow;
uniform vec3 terrainForest;
uniform vec3 terrainSand;
uniform vec3 terrainSnow;
uniform vec3 terrainWater;
uniform float terrainStrata;
uniform float terrainShore; // the share of water in the land map at which the beach begins, 0 ... 1
