// What a VTK mapper's shaders are asked for: one program serves the picture, the light pass and the view samples, so that none
// is ever rebuilt in between.
uniform int rtwPhase; // 0 picture, 1 light pass, 2 view samples
uniform int rtwLayer; // of the light pass
uniform int rtwLightParallel;
