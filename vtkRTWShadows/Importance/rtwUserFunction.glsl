// The head of the user's own importance function; its body and the closing brace follow. Position and normal are in view coordinates, the
// normal towards the viewer; footprint is the extent of a pixel along s and t, as a share of the focus.
float rtwUserFunction(vec3 position, vec3 normal, float depth, float luminance, vec2 footprint)
{
